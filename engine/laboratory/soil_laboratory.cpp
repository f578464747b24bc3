#include "laboratory/soil_laboratory.hpp"

#include <tbb/parallel_for.h>

#include "base/console.hpp"
#include "dem/make_assembly.hpp"
#include "dem/packing/observe.hpp"
#include "packings/base_packing.hpp"

namespace sandgraph::laboratory {
namespace {

std::vector<dem::BiaxialRow> biaxial(const dem::Packing& packing, double pressure,
                                     const LaboratoryPlan& plan) {
    const dem::Material material;
    dem::BiaxialTest test = plan.test;
    test.confining_pressure = pressure;
    return dem::run_biaxial(*dem::fast_assemblies()(packing, material), test,
                            dem::grain_scale(packing, material));
}

void test_one(Specimen& specimen, const LaboratoryPlan& plan, Tally& tally) {
    const dem::Packing packing = packings::table1_packing(specimen.density, specimen.seed, plan.grains);
    tally.done("packings and biaxial tests");
    const dem::Material material;
    specimen.porosity = dem::porosity(packing);
    specimen.coordination =
        dem::observe(packing, dem::contact_forces(packing, material), material).coordination;
    tbb::parallel_for(std::size_t{0}, specimen.tests.size(), [&](std::size_t k) {
        specimen.tests[k] = biaxial(packing, dem::confining_pressures[k], plan);
        tally.done("packings and biaxial tests");
    });
}

}  // namespace

std::vector<Specimen> test_specimens(const LaboratoryPlan& plan, const ProgressCallback& progress) {
    std::vector<Specimen> specimens;
    for (const char* density : kDensities)
        for (int seed = 1; seed <= plan.seeds; ++seed)
            specimens.push_back({density, static_cast<std::uint64_t>(seed), 0, 0, {}});
    Tally tally(specimens.size() * (1 + dem::confining_pressures.size()), progress);
    tbb::parallel_for(std::size_t{0}, specimens.size(),
                      [&](std::size_t k) { test_one(specimens[k], plan, tally); });
    return specimens;
}

}  // namespace sandgraph::laboratory

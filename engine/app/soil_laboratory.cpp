#include "app/soil_laboratory.hpp"

#include <tbb/parallel_for.h>

#include <mutex>

#include "app/packing_cache.hpp"
#include "app/prepare_packing.hpp"
#include "dem/observe.hpp"

namespace sandgraph::app {
namespace {

// Counts finished pieces of work of all threads.
class Tally {
  public:
    Tally(std::size_t all, const dem::Progress& progress) : all_(all), progress_(progress) {}
    void done(const std::string& stage) {
        const std::lock_guard lock(telling_);
        ++done_;
        if (progress_) progress_(stage, static_cast<double>(done_) / static_cast<double>(all_));
    }

  private:
    std::size_t all_, done_ = 0;
    const dem::Progress& progress_;
    std::mutex telling_;
};

scene::Grains sand(const Specimen& specimen, const LaboratoryPlan& plan) {
    scene::Grains grains;
    grains.count = plan.grains;
    grains.seed = specimen.seed;
    grains.density = specimen.density;
    grains.target_porosity = specimen.density == "dense" ? 0.16 : 0.20;
    return grains;
}

dem::Packing packing_of(const scene::Grains& grains) {
    return cached_packing(packing_recipe(grains) + "base\n", grains.material,
                          [&] { return base_packing(grains); });
}

std::vector<dem::BiaxialRow> biaxial(const dem::Packing& packing, double pressure,
                                     const LaboratoryPlan& plan) {
    const dem::Material material;
    dem::BiaxialTest test{
        .confining_pressure = pressure, .axial_rate = plan.axial_rate, .axial_strain = plan.axial_strain};
    test.modulus = dem::typical_modulus(packing, material);
    return dem::run_biaxial(*fast_assemblies()(packing, material), test);
}

void test_one(Specimen& specimen, const LaboratoryPlan& plan, Tally& tally) {
    const scene::Grains grains = sand(specimen, plan);
    const dem::Packing packing = packing_of(grains);
    tally.done("packings and biaxial tests");
    const auto contacts = dem::contact_forces(packing, grains.material);
    specimen.porosity = dem::porosity(packing);
    specimen.coordination = dem::observe(packing, contacts, grains.material).coordination;
    tbb::parallel_for(std::size_t{0}, specimen.tests.size(), [&](std::size_t k) {
        specimen.tests[k] = biaxial(packing, kConfiningPressures[k], plan);
        tally.done("packings and biaxial tests");
    });
}

}  // namespace

std::vector<Specimen> test_specimens(const LaboratoryPlan& plan, const dem::Progress& progress) {
    std::vector<Specimen> specimens;
    for (const char* density : kDensities)
        for (int seed = 1; seed <= plan.seeds; ++seed)
            specimens.push_back({density, static_cast<std::uint64_t>(seed), 0, 0, {}});
    Tally tally(specimens.size() * (1 + kConfiningPressures.size()), progress);
    tbb::parallel_for(std::size_t{0}, specimens.size(),
                      [&](std::size_t k) { test_one(specimens[k], plan, tally); });
    return specimens;
}

}  // namespace sandgraph::app

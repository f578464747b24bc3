#include "packings/friction.hpp"

#include <tbb/parallel_for.h>

#include <array>

#include "dem/element_test/element_test.hpp"
#include "dem/make_assembly.hpp"
#include "packings/cache.hpp"

namespace sandgraph::packings {
namespace {

double run_tests(const dem::Packing& packing, const dem::Material& material) {
    std::array<dem::PeakFriction, dem::confining_pressures.size()> peaks;
    const dem::GrainScale grains = dem::grain_scale(packing, material);
    tbb::parallel_for(std::size_t{0}, peaks.size(), [&](std::size_t k) {
        const auto sample = dem::fast_assemblies()(packing, material);
        const dem::BiaxialTest test{.confining_pressure = dem::confining_pressures[k] * grains.stiffness,
                                    .axial_strain = dem::peak_strain};
        peaks[k] = dem::peak_friction(dem::run_biaxial(*sample, test, grains));
    });
    return dem::friction_angle(peaks);
}

}  // namespace

double measured_friction(const dem::Packing& packing, const dem::Material& material,
                         const std::string& recipe, const ProgressCallback& progress) {
    return cached_numbers(recipe + "peak friction angle\n", 1, [&] {
        if (progress) progress("biaxial tests of the packing", 0);
        return std::vector<double>{run_tests(packing, material)};
    })[0];
}

}  // namespace sandgraph::packings

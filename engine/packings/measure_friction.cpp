#include "packings/measure_friction.hpp"

#include <tbb/parallel_for.h>

#include <array>

#include "dem/element_test/element_test.hpp"
#include "packings/packing_cache.hpp"
#include "packings/prepare_packing.hpp"
#include "packings/rve_options.hpp"

namespace sandgraph::packings {
namespace {

constexpr std::array<double, 3> kPressures = {32e3, 64e3, 128e3};  // [Pa]
constexpr double kStrain = 0.1;

double run_tests(const dem::Packing& packing, const dem::Material& material) {
    std::array<dem::PeakFriction, 3> peaks;
    tbb::parallel_for(std::size_t{0}, peaks.size(), [&](std::size_t k) {
        const auto sample = fast_assemblies()(packing, material);
        dem::BiaxialTest test{.confining_pressure = kPressures[k], .axial_strain = kStrain};
        test.modulus = dem::typical_modulus(packing, material);
        test.dt = preparation_time_step(material, packing.r);
        peaks[k] = dem::peak_friction(dem::run_biaxial(*sample, test), kStrain);
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

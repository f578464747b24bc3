#include "dem/element_test/sample.hpp"

#include <fmt/format.h>

#include "base/contracts.hpp"
#include "base/error.hpp"
#include "dem/packing/packing.hpp"

namespace sandgraph::dem {

SampleOnStand::SampleOnStand(Assembly& assembly, double dt)
    : assembly_(assembly), dt_(dt), H_0_(assembly.cell()) {}

// As the cell: each step first applies the L of the step before.
void SampleOnStand::step(const Mat2& L, int count) {
    SG_EXPECT(count >= 0 && dt_ > 0);
    assembly_.step(L, dt_, count);
    for (int k = 0; k < count; ++k) {
        F_ += dt_ * (L_last_ * F_);
        L_last_ = L;
    }
    steps_ += count;
}

ElementRow SampleOnStand::row() {
    ElementRow row{steps_, static_cast<double>(steps_) * dt_, F_, periods(), assembly_.observe()};
    if (row.seen.stress.allFinite() && row.seen.porosity > crushed_porosity) return row;
    throw InputError({"element test", 0}, fmt::format("the sample is lost by step {}", steps_),
                     row.seen.stress.allFinite()
                         ? fmt::format("porosity {:.2f}: its grains lie in each other", row.seen.porosity)
                         : std::string("stress is not finite"),
                     "compress it less, or take a shorter time step");
}

double typical_modulus(std::span<const double> radii, const Material& material) {
    SG_EXPECT(!radii.empty() && material.depth > 0);
    double sum = 0;
    for (double r : radii) sum += r;
    const double r_mean = sum / static_cast<double>(radii.size());
    return 0.5 * material.young * r_mean / material.depth;
}

double typical_modulus(const Packing& packing, const Material& material) {
    return typical_modulus(packing.r, material);
}

}  // namespace sandgraph::dem

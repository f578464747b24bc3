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

void by_grains(double& pressure, double& rate, double& time_step, const GrainScale& grains) {
    SG_EXPECT(pressure >= 0 && rate >= 0 && time_step >= 0);
    if (pressure == 0) pressure = usual_pressure * grains.stiffness;
    if (rate == 0) rate = usual_rate / grains.slowness;
    if (time_step == 0) time_step = grains.time_step;
}

}  // namespace sandgraph::dem

#include "dem/fast/fast.hpp"

#include <Eigen/LU>

#include "base/contracts.hpp"
#include "dem/fast/packing.hpp"
#include "dem/packing/observe.hpp"

namespace sandgraph::dem {
FastAssembly::FastAssembly(const Packing& packing, const Material& material)
    : material_(material), constants_(kernel_constants(material)), order_(memory_order(packing)) {
    SG_EXPECT(packing.size() > 0 && packing.area() > 0);
    const Packing ordered = reordered(packing, order_);
    load(ordered, material, state_);
    neighbours_.relist(state_, ordered.contacts);
    stress_ = love_weber_stress(packing, contact_forces(packing, material), material);
}

void FastAssembly::step(const Mat2& L, double dt, int count) {
    SG_EXPECT(dt > 0 && count >= 0);
    dt_ = dt;
    double sum[4];
    for (int k = 0; k < count; ++k) {
        if (neighbours_.stale(state_)) neighbours_.rebuild(state_), ++rebuilds_;
        const bool last = k + 1 == count;
        contact_forces(state_, constants_, dt, last ? sum : nullptr);
        const double speed2 = kick_drift(state_, constants_, L, dt);
        state_.approach += neighbours_.approach(state_, speed2, dt);
    }
    if (count < 1) return;
    const double volume = state_.H_force.determinant() * material_.depth;
    stress_ << sum[0] / volume, sum[1] / volume, sum[2] / volume, sum[3] / volume;
}

// The grains have moved once since the forces were taken; step back to where those belong.
Observables FastAssembly::observe() {
    Packing p = unload(state_);
    p.H = state_.H_force;
    for (std::size_t g = 0; g < p.size(); ++g) p.x[g] -= dt_ * p.vx[g], p.y[g] -= dt_ * p.vy[g];
    return dem::observe(p, contact_forces(p, material_), material_);
}

Packing FastAssembly::packing() const { return reordered(unload(state_), inverse_order(order_)); }

}  // namespace sandgraph::dem

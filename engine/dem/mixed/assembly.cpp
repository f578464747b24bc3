#include "dem/mixed/assembly.hpp"

#include <Eigen/LU>

#include "base/contracts.hpp"
#include "dem/fast/packing.hpp"
#include "dem/mixed/kernel.hpp"
#include "dem/mixed/packing.hpp"
#include "dem/mixed/visit.hpp"
#include "dem/packing/observe.hpp"

namespace sandgraph::dem {

MixedAssembly::MixedAssembly(const Packing& packing, const Material& material)
    : material_(material), constants_(kernel_constants(material)), order_(memory_order(packing)) {
    SG_EXPECT(packing.size() > 0 && packing.area() > 0);
    const Packing ordered = reordered(packing, order_);
    radii_ = ordered.r;
    load(ordered, material, state_, list_);
    stress_ = love_weber_stress(packing, contact_forces(packing, material), material);
}

void MixedAssembly::step(const Mat2& L, double dt, int count) {
    SG_EXPECT(dt > 0 && count >= 0);
    if (count < 1) return;
    MixedPacking& p = state_.packing;
    double sum[4], rate2 = drift(state_, p.L, waiting_);
    rebuilds_ += keep_list(state_, list_, rate2, waiting_);
    for (int k = 0; k + 1 < count; ++k) {
        contact_forces(state_, constants_, dt, nullptr);
        rate2 = kick_drift(state_, constants_, L, dt);
        rebuilds_ += keep_list(state_, list_, rate2, dt);
    }
    contact_forces(state_, constants_, dt, sum);
    kick(state_, constants_, dt);
    drift(state_, L, 0);  // the jump alone
    waiting_ = dt;
    const double volume = p.H.determinant() * material_.depth;
    stress_ << sum[0] / volume, sum[1] / volume, sum[2] / volume, sum[3] / volume;
}

Observables MixedAssembly::observe() {
    const Packing p = to_packing(state_.packing, radii_);
    return dem::observe(p, contact_forces(p, material_), material_);
}

// With the move that waits made.
Packing MixedAssembly::packing() const {
    Packing p = to_packing(state_.packing, radii_);
    for (std::size_t g = 0; g < p.size(); ++g) p.x[g] += waiting_ * p.vx[g], p.y[g] += waiting_ * p.vy[g];
    p.H += waiting_ * (p.L * p.H);
    return reordered(p, inverse_order(order_));
}

}  // namespace sandgraph::dem

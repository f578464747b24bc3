#include "dem/mixed/kernel.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dem/mixed/kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "base/contracts.hpp"
#include "dem/mixed/forces-inl.hpp"
#include "dem/mixed/motion-inl.hpp"
#include "dem/mixed/search-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sandgraph::dem::HWY_NAMESPACE {

void MixedForces(MixedState& s, const KernelConstants& k, double dt, double* sum) {
    mixed::Forces(s, k, dt, sum);
}
double MixedKick(MixedState& s, const KernelConstants& k, double dt) { return mixed::KickOnly(s, k, dt); }
double MixedKickMove(MixedState& s, const KernelConstants& k, const Mat2& H, double jump, double dt) {
    return mixed::KickMove(s, k, H, jump, dt);
}
double MixedMove(MixedState& s, const Mat2& H, double jump, double dt) {
    return mixed::MoveOnly(s, H, jump, dt);
}
void MixedSearch(const MixedPacking& p, const float* reach, std::vector<NearPair>& pairs) {
    mixed::Search(p, reach, pairs);
}

}  // namespace sandgraph::dem::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sandgraph::dem {

HWY_EXPORT(MixedForces);
HWY_EXPORT(MixedKick);
HWY_EXPORT(MixedKickMove);
HWY_EXPORT(MixedMove);
HWY_EXPORT(MixedSearch);

namespace {

// What the loops take for granted: whole blocks, arrays of one length.
[[maybe_unused]] bool grains_fit(const MixedState& s) {
    const std::size_t room = s.packing.room();
    const auto all = [room](const auto&... arrays) { return ((arrays.size() == room) && ...); };
    const MixedPacking& p = s.packing;
    return p.grains >= 0 && room % MixedPacking::kLanes == 0 && room > std::size_t(p.grains) &&
           all(p.y, p.x_rest, p.y_rest, p.inverse_allowance2, p.u, p.v, p.w, s.radius, s.inverse_mass,
               s.inverse_inertia, s.fx_on_first, s.fy_on_first, s.torque_on_first) &&
           s.record.size() == 8 * room && s.on_second.size() == 4 * room;
}
[[maybe_unused]] bool pairs_fit(const MixedState& s) {
    const MixedPacking& p = s.packing;
    std::size_t rows = 0;
    for (const std::uint8_t of_block : p.rows) rows += of_block;
    const std::size_t slots = MixedPacking::kLanes * (rows + p.loose_gap.size());
    return MixedPacking::kLanes * p.rows.size() == p.room() &&
           MixedPacking::kLanes * p.loose_gap.size() == p.loose_first.size() && p.partner.size() == slots &&
           p.tangential.size() == slots && p.moment.size() == slots && s.stiffness.size() == slots;
}

// docs/how_it_works.md (eq. 16); returns the jump of the mean spin.
double move_cell(MixedPacking& p, const Mat2& L, double dt) {
    const Mat2 change = L - p.L;
    p.H += dt * (L * p.H), p.L = L;
    return 0.5 * (change(1, 0) - change(0, 1));
}

}  // namespace

void contact_forces(MixedState& state, const KernelConstants& k, double dt, double* moment_sum) {
    SG_EXPECT(grains_fit(state) && pairs_fit(state) && dt > 0);
    HWY_DYNAMIC_DISPATCH(MixedForces)(state, k, dt, moment_sum);
}

double kick(MixedState& state, const KernelConstants& k, double dt) {
    SG_EXPECT(grains_fit(state) && dt > 0);
    return HWY_DYNAMIC_DISPATCH(MixedKick)(state, k, dt);
}

double kick_drift(MixedState& state, const KernelConstants& k, const Mat2& L, double dt) {
    SG_EXPECT(grains_fit(state) && dt > 0);
    const double jump = move_cell(state.packing, L, dt);
    return HWY_DYNAMIC_DISPATCH(MixedKickMove)(state, k, state.packing.H, jump, dt);
}

double drift(MixedState& state, const Mat2& L, double dt) {
    SG_EXPECT(grains_fit(state) && dt >= 0);
    const double jump = move_cell(state.packing, L, dt);
    return HWY_DYNAMIC_DISPATCH(MixedMove)(state, state.packing.H, jump, dt);
}

void near_pairs(const MixedPacking& packing, const Aligned<float>& reach, std::vector<NearPair>& pairs) {
    SG_EXPECT(reach.size() == packing.room());
    HWY_DYNAMIC_DISPATCH(MixedSearch)(packing, reach.data(), pairs);
}

}  // namespace sandgraph::dem
#endif

#include "dem/fast/kernel.hpp"

#include <stdexcept>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dem/fast/kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "base/contracts.hpp"
#include "dem/fast/copy-inl.hpp"
#include "dem/fast/forces-inl.hpp"
#include "dem/fast/motion-inl.hpp"
#include "dem/fast/packing.hpp"

#if HWY_ONCE
namespace sandgraph::dem {

HWY_EXPORT(ContactForces);
HWY_EXPORT(ContactForcesAndStress);
HWY_EXPORT(Kick);
HWY_EXPORT(KickDrift);
HWY_EXPORT(Drift);
HWY_EXPORT(UnpackGrains);
HWY_EXPORT(PackGrains);
HWY_EXPORT(Widen);
HWY_EXPORT(Narrow);
HWY_EXPORT(TargetName);

namespace {

// The cell moves with the grains: H <- (I + dt L) H.
void move_cell(FastState& s, const Mat2& L, double dt) {
    s.LH = L * s.H;  // docs/how_it_works.md (eq. 16)
    s.H += dt * s.LH;
    s.L = L;
}

// What the loops take for granted: whole lanes everywhere, and arrays of one length.
[[maybe_unused]] bool grains_fit(const FastState& s) {
    const auto room = static_cast<std::size_t>(padded(s.grains + 1));
    return s.grains >= 0 && s.record.size() == FastState::kRecord * room && s.force.size() == 4 * room &&
           s.inverse_mass.size() == room && s.inverse_inertia.size() == room;
}
[[maybe_unused]] bool pairs_fit(const FastState& s) {
    const auto slots = static_cast<std::size_t>(s.slots);
    return s.slots % FastState::kLanes == 0 && s.inner % FastState::kLanes == 0 && s.inner <= s.slots &&
           s.i.size() == slots && s.j.size() == slots && s.image.size() == slots &&
           s.tangential.size() == slots && s.moment.size() == slots;
}

}  // namespace

void contact_forces(FastState& state, const KernelConstants& k, double dt, double* moment_sum) {
    SG_EXPECT(grains_fit(state) && pairs_fit(state));
    SG_EXPECT(dt > 0);
    state.H_force = state.H;
    if (moment_sum)
        HWY_DYNAMIC_DISPATCH(ContactForcesAndStress)(state, k, dt, moment_sum);
    else
        HWY_DYNAMIC_DISPATCH(ContactForces)(state, k, dt);
}

double kick(FastState& state, const KernelConstants& k, double dt) {
    SG_EXPECT(grains_fit(state) && dt > 0);
    return HWY_DYNAMIC_DISPATCH(Kick)(state, k, dt);
}

double kick_drift(FastState& state, const KernelConstants& k, const Mat2& L, double dt) {
    SG_EXPECT(grains_fit(state) && dt > 0);
    const double speed2 = HWY_DYNAMIC_DISPATCH(KickDrift)(state, k, L, dt);
    move_cell(state, L, dt);
    return speed2;
}

double drift(FastState& state, const Mat2& L, double dt) {
    SG_EXPECT(grains_fit(state) && dt > 0);
    const double speed2 = HWY_DYNAMIC_DISPATCH(Drift)(state, L, dt);
    move_cell(state, L, dt);
    return speed2;
}

void unpack_grains(const double* position, const float* velocity, const double* radius, int grains,
                   double* records) {
    SG_EXPECT(grains == 0 || (position && velocity && radius && records));
    HWY_DYNAMIC_DISPATCH(UnpackGrains)(position, velocity, radius, grains, records);
}

void pack_grains(const double* records, int grains, double* position, float* velocity) {
    SG_EXPECT(grains == 0 || (records && position && velocity));
    HWY_DYNAMIC_DISPATCH(PackGrains)(records, grains, position, velocity);
}

void widen(const float* from, int count, double* to) {
    SG_EXPECT(count % FastState::kLanes == 0);
    HWY_DYNAMIC_DISPATCH(Widen)(from, count, to);
}
void narrow(const double* from, int count, float* to) {
    SG_EXPECT(count % FastState::kLanes == 0);
    HWY_DYNAMIC_DISPATCH(Narrow)(from, count, to);
}

std::string kernel_target() { return HWY_DYNAMIC_DISPATCH(TargetName)(); }

std::vector<std::string> kernel_targets() {
    std::vector<std::string> names;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets())
        names.push_back(hwy::TargetName(target));
    return names;
}

void use_kernel_target(const std::string& name) {
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets())
        if (name == hwy::TargetName(target)) return hwy::GetChosenTarget().Update(target);
    throw std::invalid_argument("this machine has no kernel for the instruction set " + name);
}

}  // namespace sandgraph::dem
#endif

// Grain loop of the mixed-precision kernel; included once per instruction set (no include guard by design).
// Equations: docs/how_it_works.md.
#if defined(SANDGRAPH_MIXED_MOTION_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SANDGRAPH_MIXED_MOTION_INL
#undef SANDGRAPH_MIXED_MOTION_INL
#else
#define SANDGRAPH_MIXED_MOTION_INL
#endif

#include <limits>

#include "dem/mixed/forces-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sandgraph::dem::HWY_NAMESPACE::mixed {

// a (1 - alpha sign(a (w + dt a/2))), Cundall's local damping on the velocity w (eq. 21).
HWY_INLINE V Damped(V a, V w, V half_dt, V alpha) {
    const V power = hn::Mul(a, hn::MulAdd(half_dt, a, w));
    return hn::NegMulAdd(a, hn::CopySign(alpha, power), a);
}

// Velocities relative to the mean field obey u <- u + dt a alone: (eq. 21) and (eq. 22) give them their
// convective part and take it off again.
struct Kick {
    V dt, half_dt, alpha;
    Kick(double damping, double step)
        : dt(hn::Set(D(), float(step))),
          half_dt(hn::Set(D(), float(0.5 * step))),
          alpha(hn::Set(D(), float(damping))) {}
    HWY_INLINE V operator()(V velocity, V force, V inverse_mass) const {
        return hn::MulAdd(dt, Damped(hn::Mul(force, inverse_mass), velocity, half_dt, alpha), velocity);
    }
    HWY_INLINE void operator()(const MixedState& s, int g, V& u, V& v, V& w) const {
        const D d;
        V f[4];
        LoadColumns(s.on_second.data() + kForce * FirstPlace(g), f);
        const V im = hn::Load(d, s.inverse_mass.data() + g), ii = hn::Load(d, s.inverse_inertia.data() + g);
        u = (*this)(u, hn::Add(f[0], hn::Load(d, s.fx_on_first.data() + g)), im);
        v = (*this)(v, hn::Add(f[1], hn::Load(d, s.fy_on_first.data() + g)), im);
        w = (*this)(w, hn::Add(f[2], hn::Load(d, s.torque_on_first.data() + g)), ii);
    }
};

// (eq. 22) in shares of the period after the move: the mean field moves with the cell. `turn` is the jump of
// the spin.
struct Move {
    Tensor units;
    V turn;
    Move(const Mat2& H_after, double jump, double dt)
        : units(dt / kUnit * H_after.inverse()), turn(hn::Set(D(), float(jump))) {}
    // What is less than a unit is kept for the next move: slow grains would stand still while their
    // tangential forces follow their velocities.
    static HWY_INLINE VI Moved(V by, std::int32_t* coordinate, float* rest) {
        const D d;
        const DI di;
        const V whole_and_rest = hn::Add(by, hn::Load(d, rest));
        const VI whole = hn::NearestInt(whole_and_rest);
        hn::Store(hn::Sub(whole_and_rest, hn::ConvertTo(d, whole)), d, rest);
        const VI moved = hn::Add(hn::Load(di, coordinate), whole);
        hn::Store(moved, di, coordinate);
        return moved;
    }
    HWY_INLINE void operator()(MixedState& s, int g, V u, V v, V& w) const {
        w = hn::Add(w, turn);
        const VI x = Moved(units.x(u, v), s.packing.x.data() + g, s.packing.x_rest.data() + g),
                 y = Moved(units.y(u, v), s.packing.y.data() + g, s.packing.y_rest.data() + g);
        const V r = hn::Load(D(), s.radius.data() + g), zero = hn::Zero(D());
        const V first[4] = {hn::BitCast(D(), x), hn::BitCast(D(), y), u, v}, last[4] = {w, r, zero, zero};
        StoreRecords(first, last, s.record.data() + kRecord * FirstPlace(g));
    }
};

// Returns max (|u|/allowance)^2, not a number if any velocity is.
template <bool kKick, bool kMove>
HWY_INLINE double MotionLoop(MixedState& s, const Kick& kick, const Move& move) {
    const D d;
    V largest = hn::Zero(d), sum = hn::Zero(d);
    const int room = static_cast<int>(s.packing.room());
    for (int g = 0; g < room; g += kLanes) {
        float *const pu = s.packing.u.data() + g, *const pv = s.packing.v.data() + g,
                     *const pw = s.packing.w.data() + g;
        V u = hn::Load(d, pu), v = hn::Load(d, pv), w = hn::Load(d, pw);
        if constexpr (kKick) kick(s, g, u, v, w);
        if constexpr (kMove) move(s, g, u, v, w);
        hn::Store(u, d, pu), hn::Store(v, d, pv), hn::Store(w, d, pw);
        const V square = hn::MulAdd(u, u, hn::Mul(v, v));
        const V share = hn::Mul(square, hn::Load(d, s.packing.inverse_allowance2.data() + g));
        largest = hn::Max(largest, share), sum = hn::Add(sum, hn::MulAdd(w, w, square));
    }
    const float total = hn::GetLane(hn::SumOfLanes(d, sum));
    if (!(total < std::numeric_limits<float>::infinity())) return std::numeric_limits<double>::quiet_NaN();
    return hn::GetLane(hn::MaxOfLanes(d, largest));
}

double KickOnly(MixedState& s, const KernelConstants& k, double dt) {
    return MotionLoop<true, false>(s, Kick(k.damping, dt), Move(s.packing.H, 0, dt));
}
double KickMove(MixedState& s, const KernelConstants& k, const Mat2& H_after, double jump, double dt) {
    return MotionLoop<true, true>(s, Kick(k.damping, dt), Move(H_after, jump, dt));
}
double MoveOnly(MixedState& s, const Mat2& H_after, double jump, double dt) {
    return MotionLoop<false, true>(s, Kick(0, dt), Move(H_after, jump, dt));
}

}  // namespace sandgraph::dem::HWY_NAMESPACE::mixed
HWY_AFTER_NAMESPACE();
#endif

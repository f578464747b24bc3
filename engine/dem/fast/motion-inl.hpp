// Grain loop of the fast kernel; included once per instruction set (no include guard by design). Equations:
// docs/how_it_works.md.
#if defined(SANDGRAPH_FAST_MOTION_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SANDGRAPH_FAST_MOTION_INL
#undef SANDGRAPH_FAST_MOTION_INL
#else
#define SANDGRAPH_FAST_MOTION_INL
#endif

#include "dem/fast/forces-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sandgraph::dem::HWY_NAMESPACE {

struct Gradient {
    V xx, xy, yx, yy;
    explicit Gradient(const Mat2& m)
        : xx(hn::Set(D(), m(0, 0))),
          xy(hn::Set(D(), m(0, 1))),
          yx(hn::Set(D(), m(1, 0))),
          yy(hn::Set(D(), m(1, 1))) {}
    HWY_INLINE V x(V u, V v) const { return hn::MulAdd(xx, u, hn::Mul(xy, v)); }
    HWY_INLINE V y(V u, V v) const { return hn::MulAdd(yx, u, hn::Mul(yy, v)); }
};

// a (1 - alpha sign(a (w + dt a/2))), Cundall's local damping on the velocity w (eq. 21).
HWY_INLINE V Damped(V a, V w, V half_dt, V alpha) {
    const V power = hn::Mul(a, hn::MulAdd(half_dt, a, w));
    return hn::NegMulAdd(a, hn::CopySign(alpha, power), a);
}

#if HWY_MAX_BYTES == 64

// Eight records.
HWY_INLINE void LoadGrains(const double* records, V& x, V& y, V& vx, V& vy, V& r, V& w) {
    V geometry[4], rotation[4], p[4], q[4];
    for (int k = 0; k < 4; ++k) {
        const double* a = records + kRecord * JoinedRow(k);
        geometry[k] = Join(a, a + 2 * kRecord), rotation[k] = Join(a + 4, a + 2 * kRecord + 4);
    }
    Columns(geometry, p), Columns(rotation, q);
    x = p[0], y = p[1], vx = p[2], vy = p[3], r = q[0], w = q[2];
}
HWY_INLINE void StoreGrains(V x, V y, V vx, V vy, V r, V w, double* records) {
    StoreRows(x, y, vx, vy, records, kRecord);
    StoreRows(r, hn::Mul(r, w), w, r, records + 4, kRecord);
}

#else

HWY_INLINE void LoadGrains(const double* records, V& x, V& y, V& vx, V& vy, V& r, V& w) {
    alignas(64) double a[4 * 8], b[4 * 8];
    const D d;
    const D4 d4;
    for (std::size_t g = 0; g < hn::Lanes(d); ++g)
        for (std::size_t k = 0; k < 4; k += hn::Lanes(d4)) {
            hn::Store(hn::Load(d4, records + kRecord * g + k), d4, a + 4 * g + k);
            hn::Store(hn::Load(d4, records + kRecord * g + 4 + k), d4, b + 4 * g + k);
        }
    V rw, r2;
    hn::LoadInterleaved4(d, a, x, y, vx, vy);
    hn::LoadInterleaved4(d, b, r, rw, w, r2);
}
HWY_INLINE void StoreGrains(V x, V y, V vx, V vy, V r, V w, double* records) {
    alignas(64) double a[4 * 8], b[4 * 8];
    const D d;
    const D4 d4;
    hn::StoreInterleaved4(x, y, vx, vy, d, a);
    hn::StoreInterleaved4(r, hn::Mul(r, w), w, r, d, b);
    for (std::size_t g = 0; g < hn::Lanes(d); ++g)
        for (std::size_t k = 0; k < 4; k += hn::Lanes(d4)) {
            hn::Store(hn::Load(d4, a + 4 * g + k), d4, records + kRecord * g + k);
            hn::Store(hn::Load(d4, b + 4 * g + k), d4, records + kRecord * g + 4 + k);
        }
}

#endif

// `kKick`: velocities from forces (eq. 21); `kJump`: to the new gradient, `kDrift`: move (eq. 22). Returns
// max |v - L x|^2.
template <bool kKick, bool kDrift, bool kJump>
HWY_INLINE double MotionLoop(FastState& s, double damping, const Mat2& L_new, double dt) {
    const D d;
    const Gradient L(s.L), jump(L_new - s.L), L_after(kDrift ? L_new : s.L);
    const V spin_jump = hn::Set(d, 0.5 * ((L_new(1, 0) - s.L(1, 0)) - (L_new(0, 1) - s.L(0, 1))));
    const V step = hn::Set(d, dt), half_dt = hn::Set(d, 0.5 * dt), alpha = hn::Set(d, damping);
    V largest = hn::Zero(d);
    for (int g = 0; g < s.grains; g += static_cast<int>(hn::Lanes(d))) {
        V x, y, vx, vy, r, w;
        LoadGrains(s.grain(g), x, y, vx, vy, r, w);
        if constexpr (kKick) {
            V fx, fy, ti, tj;
            hn::LoadInterleaved4(d, &s.force[4 * g], fx, fy, ti, tj);
            const V im = hn::Load(d, &s.inverse_mass[g]), ii = hn::Load(d, &s.inverse_inertia[g]);
            const V ax = Damped(hn::Mul(fx, im), hn::Sub(vx, L.x(x, y)), half_dt, alpha);
            const V ay = Damped(hn::Mul(fy, im), hn::Sub(vy, L.y(x, y)), half_dt, alpha);
            const V b = Damped(hn::Mul(hn::Add(ti, tj), ii), w, half_dt, alpha);
            const V cx = L.x(vx, vy), cy = L.y(vx, vy);
            vx = hn::MulAdd(step, hn::Add(ax, cx), vx);
            vy = hn::MulAdd(step, hn::Add(ay, cy), vy);
            w = hn::MulAdd(step, b, w);
        }
        if constexpr (kJump) {
            vx = hn::Add(vx, jump.x(x, y));
            vy = hn::Add(vy, jump.y(x, y));
            w = hn::Add(w, spin_jump);
        }
        const V ux = hn::Sub(vx, L_after.x(x, y)), uy = hn::Sub(vy, L_after.y(x, y));
        largest = hn::Max(largest, hn::MulAdd(ux, ux, hn::Mul(uy, uy)));
        if constexpr (kDrift) {
            x = hn::MulAdd(step, vx, x);
            y = hn::MulAdd(step, vy, y);
        }
        StoreGrains(x, y, vx, vy, r, w, s.grain(g));
    }
    return hn::GetLane(hn::MaxOfLanes(d, largest));
}

double Kick(FastState& s, const KernelConstants& k, double dt) {
    return MotionLoop<true, false, false>(s, k.damping, s.L, dt);
}
double KickDrift(FastState& s, const KernelConstants& k, const Mat2& L, double dt) {
    return L == s.L ? MotionLoop<true, true, false>(s, k.damping, L, dt)
                    : MotionLoop<true, true, true>(s, k.damping, L, dt);
}
double Drift(FastState& s, const Mat2& L, double dt) { return MotionLoop<false, true, true>(s, 0, L, dt); }

const char* TargetName() { return hwy::TargetName(HWY_TARGET); }

}  // namespace sandgraph::dem::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

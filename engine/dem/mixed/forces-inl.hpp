// Pair loop of the mixed-precision kernel; included once per instruction set (no include guard by design).
// Equations: docs/how_it_works.md.
#if defined(SANDGRAPH_MIXED_FORCES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SANDGRAPH_MIXED_FORCES_INL
#undef SANDGRAPH_MIXED_FORCES_INL
#else
#define SANDGRAPH_MIXED_FORCES_INL
#endif

#include <Eigen/LU>
#include <algorithm>

#include "dem/fast/state.hpp"
#include "dem/mixed/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sandgraph::dem::HWY_NAMESPACE::mixed {

inline constexpr double kUnit = 1.0 / 4294967296.0;  // of a coordinate, in periods

struct Tensor {
    V xx, xy, yx, yy;
    explicit Tensor(const Mat2& m)
        : xx(hn::Set(D(), float(m(0, 0)))),
          xy(hn::Set(D(), float(m(0, 1)))),
          yx(hn::Set(D(), float(m(1, 0)))),
          yy(hn::Set(D(), float(m(1, 1)))) {}
    HWY_INLINE V x(V a, V b) const { return hn::MulAdd(xx, a, hn::Mul(xy, b)); }
    HWY_INLINE V y(V a, V b) const { return hn::MulAdd(yx, a, hn::Mul(yy, b)); }
};

// |d|^2 = g_xx a^2 + 2 g_xy a b + g_yy b^2 of a branch with the components a, b in units of the cell.
struct Metric {
    double xx, xy2, yy;
    explicit Metric(const Mat2& H) {
        const Mat2 g = kUnit * kUnit * (H.transpose() * H);
        xx = g(0, 0), xy2 = 2 * g(0, 1), yy = g(1, 1);
    }
};

#if HWY_TARGET == HWY_SCALAR
HWY_INLINE V Excess(const Metric& g, VI a, VI b, V distance) {
    const double x = hn::GetLane(a), y = hn::GetLane(b), d = hn::GetLane(distance);
    return hn::Set(D(), float(x * (g.xx * x + g.xy2 * y) + g.yy * y * y - d * d));
}
#else
using HalfI = hn::Half<DI>;
using HalfF = hn::Half<D>;
using DD = hn::Rebind<double, HalfF>;

HWY_INLINE hn::Vec<HalfF> Excess(const Metric& g, hn::Vec<HalfI> a, hn::Vec<HalfI> b,
                                 hn::Vec<HalfF> distance) {
    const DD d;
    const auto x = hn::PromoteTo(d, a), y = hn::PromoteTo(d, b), r = hn::PromoteTo(d, distance);
    const auto inner = hn::MulAdd(hn::Set(d, g.xx), x, hn::Mul(hn::Set(d, g.xy2), y));
    const auto square = hn::MulAdd(x, inner, hn::Mul(hn::Mul(hn::Set(d, g.yy), y), y));
    return hn::DemoteTo(HalfF(), hn::NegMulAdd(r, r, square));
}

// |d|^2 less the square of `distance`, which is nearly |d|, in double precision.
HWY_INLINE V Excess(const Metric& g, VI a, VI b, V distance) {
    const auto lower =
        Excess(g, hn::LowerHalf(HalfI(), a), hn::LowerHalf(HalfI(), b), hn::LowerHalf(HalfF(), distance));
    const auto upper =
        Excess(g, hn::UpperHalf(HalfI(), a), hn::UpperHalf(HalfI(), b), hn::UpperHalf(HalfF(), distance));
    return hn::Combine(D(), upper, lower);
}
#endif

#if HWY_MAX_BYTES == 64
// One Newton step on the machine's 14 bits.
HWY_INLINE void Distance(V square, V& dist, V& inv_dist) {
    const D d;
    const V guess = V{_mm512_rsqrt14_ps(square.raw)};
    const V e = hn::NegMulAdd(hn::Mul(square, guess), guess, hn::Set(d, 1.0f));
    inv_dist = hn::MulAdd(hn::Mul(guess, e), hn::Set(d, 0.5f), guess);
    dist = hn::Mul(square, inv_dist);
}
#else
HWY_INLINE void Distance(V square, V& dist, V& inv_dist) {
    dist = hn::Sqrt(square);
    inv_dist = hn::Div(hn::Set(D(), 1.0f), dist);
}
#endif

// Constants of the law and of the motion in every lane. The relative velocity of two grains is that of the
// move before (eq. 18): L d of then is L (I + dt L)^-1 of now, but for dt L times the peculiar part.
struct Law {
    V young, ratio_dt, rolling, friction, rolling_limit;
    Tensor cell, field;
    Metric metric;
    Law(const MixedPacking& p, const KernelConstants& k, double dt)
        : young(hn::Set(D(), float(2 * k.young))),
          ratio_dt(hn::Set(D(), float(k.stiffness_ratio * dt))),
          rolling(hn::Set(D(), float(k.rolling_stiffness))),
          friction(hn::Set(D(), float(k.friction))),
          rolling_limit(hn::Set(D(), float(k.rolling_limit))),
          cell(kUnit * p.H),
          field(p.L * (Mat2::Identity() + dt * p.L).inverse()),
          metric(p.H) {}
};

// A lane's own grain, the first of its pairs, and what it has collected.
struct First {
    VI x, y;
    V u, v, w, r, rw;
    V fx, fy, torque;
    First(const MixedState& s, int g)
        : x(hn::Load(DI(), s.packing.x.data() + g)),
          y(hn::Load(DI(), s.packing.y.data() + g)),
          u(hn::Load(D(), s.packing.u.data() + g)),
          v(hn::Load(D(), s.packing.v.data() + g)),
          w(hn::Load(D(), s.packing.w.data() + g)),
          r(hn::Load(D(), s.radius.data() + g)),
          rw(hn::Mul(r, w)),
          fx(hn::Zero(D())),
          fy(hn::Zero(D())),
          torque(hn::Zero(D())) {}
    explicit First(const Partners& i)
        : x(i.x),
          y(i.y),
          u(i.u),
          v(i.v),
          w(i.w),
          r(i.r),
          rw(hn::Mul(r, w)),
          fx(hn::Zero(D())),
          fy(hn::Zero(D())),
          torque(hn::Zero(D())) {}
    HWY_INLINE void Store(MixedState& s, int g) const {
        hn::Store(fx, D(), s.fx_on_first.data() + g);
        hn::Store(fy, D(), s.fy_on_first.data() + g);
        hn::Store(torque, D(), s.torque_on_first.data() + g);
    }
};

// Branch from the first to the second grain, the overlap exact to a unit of the coordinates.
struct Branch {
    V dx, dy, dist, inv_dist, r_sum, overlap;
    Branch(const First& i, const Partners& j, const Law& k) {
        const D d;
        const VI a = hn::Sub(j.x, i.x), b = hn::Sub(j.y, i.y);
        const V sx = hn::ConvertTo(d, a), sy = hn::ConvertTo(d, b);
        dx = k.cell.x(sx, sy), dy = k.cell.y(sx, sy);
        const V square = hn::MulAdd(dx, dx, hn::Mul(dy, dy));
        Distance(hn::Max(square, hn::Set(d, 1e-20f)), dist, inv_dist);
        r_sum = hn::Add(i.r, j.r);
        const V excess = Excess(k.metric, a, b, dist);
        overlap = hn::NegMulAdd(hn::Mul(hn::Set(d, 0.5f), excess), inv_dist, hn::Sub(r_sum, dist));
    }
};

HWY_INLINE V Limited(V value, V limit) { return hn::Max(hn::Min(value, limit), hn::Neg(limit)); }

// (eq. 18), with the tangential force as a scalar along (n_y, -n_x).
HWY_INLINE V Tangential(const First& i, const Partners& j, const Branch& b, V nx, V ny, V kt_dt, V limit,
                        const Law& k, float* history) {
    const D d;
    const V dvx = hn::Add(hn::Sub(j.u, i.u), k.field.x(b.dx, b.dy)),
            dvy = hn::Add(hn::Sub(j.v, i.v), k.field.y(b.dx, b.dy));
    const V slip = hn::NegMulAdd(dvy, nx, hn::Mul(dvx, ny));
    const V vt = hn::MulAdd(hn::Mul(b.r_sum, b.inv_dist), slip, hn::MulAdd(j.r, j.w, i.rw));
    const V ft = Limited(hn::NegMulAdd(kt_dt, vt, hn::Load(d, history)), limit);
    hn::Store(ft, d, history);
    return ft;
}

// (eq. 19); the total form remembers the whole -k_r theta of a pair in contact.
template <bool kTotal>
HWY_INLINE V Rolling(const First& i, const Partners& j, V kt_dt, V fn, const Law& k, float* history) {
    const D d;
    const V kr_dt = hn::Mul(hn::Mul(k.rolling, hn::Mul(i.r, j.r)), kt_dt);
    const V limit = hn::Mul(hn::Mul(k.rolling_limit, hn::Min(i.r, j.r)), fn);
    const V rolled = hn::NegMulAdd(kr_dt, hn::Sub(j.w, i.w), hn::Load(d, history));
    const V m = Limited(rolled, limit);
    hn::Store(kTotal ? hn::IfThenElseZero(hn::Gt(fn, hn::Zero(d)), rolled) : m, d, history);
    return m;
}

// The forces of one row of pairs wait here while the next row is worked out: a store takes time to be read
// again in other parts.
struct Waiting {
    alignas(64) float force[2][kForce * kLanes];
    const std::uint16_t* place = nullptr;
    int side = 0;

    // Pair by pair, so two pairs of one grain never conflict.
    HWY_INLINE void Add(float* HWY_RESTRICT on_second) {
        if (!place) return;
        const float* f = force[side ^ 1];
        HWY_UNROLL(16)
        for (int l = 0; l < kLanes; ++l) AddOne(f + RowOf(l), on_second + kForce * std::size_t{place[l]});
        place = nullptr;
    }
    HWY_INLINE void Put(const V* column, const std::uint16_t* partners) {
        V row[4];
        Transpose(column, row);
        for (int k = 0; k < 4; ++k) hn::Store(row[k], D(), force[side] + kLanes * k);
        side ^= 1, place = partners;
    }

  private:
    static constexpr int RowOf(int l) { return kLanes * (l % 4) + l / 4 * 4; }
    static HWY_INLINE void AddOne(const float* f, float* to) {
        const hn::CappedTag<float, 4> d;
        for (int k = 0; k < 4; k += int(hn::Lanes(d)))
            hn::Store(hn::Add(hn::Load(d, f + k), hn::Load(d, to + k)), d, to + k);
    }
};

// sum of d (x) f, by row in float and over rows in double.
struct Moments {
    double sum[4] = {0, 0, 0, 0};
    HWY_INLINE void Add(V dx, V dy, V fx, V fy) {
        const D d;
        const V part[4] = {hn::Mul(dx, fx), hn::Mul(dx, fy), hn::Mul(dy, fx), hn::Mul(dy, fy)};
        for (int c = 0; c < 4; ++c) sum[c] += hn::GetLane(hn::SumOfLanes(d, part[c]));
    }
};

struct Arrays {
    const float* HWY_RESTRICT record;
    float* HWY_RESTRICT on_second;
    const std::uint16_t* HWY_RESTRICT partner;
    float *HWY_RESTRICT tangential, *HWY_RESTRICT moment, *HWY_RESTRICT stiffness;
    explicit Arrays(MixedState& s)
        : record(s.record.data()),
          on_second(s.on_second.data()),
          partner(s.packing.partner.data()),
          tangential(s.packing.tangential.data()),
          moment(s.packing.moment.data()),
          stiffness(s.stiffness.data()) {}
};

// (eq. 17): k_n = E r*. The first step after a search keeps it for the others.
template <bool kKnown>
HWY_INLINE V Stiffness(const First& i, const Partners& j, V r_sum, const Law& k, float* kept) {
    if constexpr (kKnown) return hn::Load(D(), kept);
    const V safe = hn::Max(r_sum, hn::Set(D(), 1e-20f));
    const V kn = hn::Div(hn::Mul(k.young, hn::Mul(i.r, j.r)), safe);
    hn::Store(kn, D(), kept);
    return kn;
}

// The contact law on kLanes pairs at once, if any touches; else their history is cleared. Whether any does.
template <bool kKnown, bool kTotal, bool kStress>
HWY_INLINE bool Contacts(const Arrays& s, const Law& k, std::size_t c, const Partners& j, First& i, V* on_j,
                         Moments& moments) {
    const D d;
    const Branch b(i, j, k);
    const V kn = Stiffness<kKnown>(i, j, b.r_sum, k, s.stiffness + c);
    const V fn = hn::Mul(kn, hn::Max(b.overlap, hn::Zero(d)));
    if (hn::AllFalse(d, hn::Gt(fn, hn::Zero(d)))) {
        hn::Store(hn::Zero(d), d, s.tangential + c), hn::Store(hn::Zero(d), d, s.moment + c);
        return false;
    }
    const V nx = hn::Mul(b.dx, b.inv_dist), ny = hn::Mul(b.dy, b.inv_dist), kt_dt = hn::Mul(kn, k.ratio_dt);
    const V ft = Tangential(i, j, b, nx, ny, kt_dt, hn::Mul(fn, k.friction), k, s.tangential + c);
    const V m = Rolling<kTotal>(i, j, kt_dt, fn, k, s.moment + c);
    // (eq. 20): |d|/2 f_t on both, (r_j - r_i)/2 f_t + M with the sign of the grain.
    const V fx = hn::MulAdd(fn, nx, hn::Mul(ft, ny)), fy = hn::NegMulAdd(ft, nx, hn::Mul(fn, ny));
    const V half_ft = hn::Mul(hn::Set(d, 0.5f), ft);
    const V even = hn::Mul(half_ft, b.dist), odd = hn::MulAdd(half_ft, hn::Sub(j.r, i.r), m);
    i.fx = hn::Sub(i.fx, fx), i.fy = hn::Sub(i.fy, fy), i.torque = hn::Add(i.torque, hn::Sub(even, odd));
    if constexpr (kStress) moments.Add(b.dx, b.dy, fx, fy);  // (eq. 23)
    on_j[0] = fx, on_j[1] = fy, on_j[2] = hn::Add(even, odd), on_j[3] = hn::Zero(d);
    return true;
}

// The pairs of a block, row by row; what they do to its own grains stays in registers.
template <bool kKnown, bool kTotal, bool kStress>
HWY_INLINE void DealtRows(MixedState& s, const Arrays& a, const Law& law, int g, std::size_t c, int rows,
                          Waiting& waiting, Moments& moments) {
    First i(s, g);
    for (int row = 0; row < rows; ++row, c += MixedPacking::kLanes) {
        V on_j[4];
        const Partners j = LoadPartners(a.record, a.partner + c);
        waiting.Add(a.on_second);
        if (Contacts<kKnown, kTotal, kStress>(a, law, c, j, i, on_j, moments))
            waiting.Put(on_j, a.partner + c);
    }
    i.Store(s, g);
}

// Loose rows that grains may have come to touch in, from slot c on.
template <bool kTotal, bool kStress>
HWY_INLINE void LooseRows(const MixedPacking& p, const Arrays& a, const Law& law, std::size_t c,
                          Moments& moments) {
    Waiting on_first, on_second;
    for (std::size_t row = 0; row < p.loose_gap.size() && p.loose_gap[row] <= p.wear; ++row)
        for (std::size_t l = 0; l < std::size_t{MixedPacking::kLanes}; l += kLanes) {
            const std::size_t at = MixedPacking::kLanes * row + l;
            const std::uint16_t *first = p.loose_first.data() + at, *second = a.partner + c + at;
            V on_j[4];
            First i(LoadPartners(a.record, first));
            const Partners j = LoadPartners(a.record, second);
            if (!Contacts<false, kTotal, kStress>(a, law, c + at, j, i, on_j, moments)) continue;
            const V on_i[4] = {i.fx, i.fy, i.torque, hn::Zero(D())};
            on_first.Put(on_i, first), on_second.Put(on_j, second);
            on_first.Add(a.on_second), on_second.Add(a.on_second);
        }
}

template <bool kKnown, bool kTotal, bool kStress>
HWY_INLINE void ForceLoop(MixedState& s, const KernelConstants& constants, double dt, Moments& moments) {
    std::fill(s.on_second.begin(), s.on_second.end(), 0.0f);
    const MixedPacking& p = s.packing;
    const Law law(p, constants, dt);
    const Arrays arrays(s);
    Waiting waiting;
    std::size_t c = 0;
    for (std::size_t block = 0; block < p.rows.size(); ++block) {
        for (int l = 0; l < MixedPacking::kLanes; l += kLanes)
            DealtRows<kKnown, kTotal, kStress>(s, arrays, law, int(block) * MixedPacking::kLanes + l, c + l,
                                               p.rows[block], waiting, moments);
        c += MixedPacking::kLanes * p.rows[block];
    }
    waiting.Add(arrays.on_second);
    LooseRows<kTotal, kStress>(p, arrays, law, c, moments);
}

template <bool kKnown, bool kTotal>
void ForcesOf(MixedState& s, const KernelConstants& k, double dt, double* moment_sum) {
    Moments moments;
    if (!moment_sum) return ForceLoop<kKnown, kTotal, false>(s, k, dt, moments);
    ForceLoop<kKnown, kTotal, true>(s, k, dt, moments);
    std::copy(moments.sum, moments.sum + 4, moment_sum);
}

void Forces(MixedState& s, const KernelConstants& k, double dt, double* moment_sum) {
    if (s.stiffness_known)
        k.total_rolling ? ForcesOf<true, true>(s, k, dt, moment_sum)
                        : ForcesOf<true, false>(s, k, dt, moment_sum);
    else
        k.total_rolling ? ForcesOf<false, true>(s, k, dt, moment_sum)
                        : ForcesOf<false, false>(s, k, dt, moment_sum);
    s.stiffness_known = true;
}

}  // namespace sandgraph::dem::HWY_NAMESPACE::mixed
HWY_AFTER_NAMESPACE();
#endif

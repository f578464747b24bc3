// Element update of the kernel; included once per instruction set (no include guard by design). Equations and
// order of operations as in features.hpp, coefficients.cpp, element_update.cpp and point_update.cpp: (eqs. 35
// to 37) of docs/how_it_works.md.
#if defined(SANDGRAPH_SURROGATE_UPDATE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SANDGRAPH_SURROGATE_UPDATE_INL
#undef SANDGRAPH_SURROGATE_UPDATE_INL
#else
#define SANDGRAPH_SURROGATE_UPDATE_INL
#endif

#include "surrogate/element_update.hpp"
#include "surrogate/kernel_network-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sandgraph::surrogate::HWY_NAMESPACE {

// A vector of points: what its members share during an update.
struct Points {
    V volume, fabric_re, fabric_im;
    V p0, e0, K0, G0, coordination, peak_friction, log_p0;
    V shear_re, shear_im, strain_volume, determinant, cos2, sin2;  // increment; phase of its rotation
    V substeps;
    int most_substeps = 1;
};

struct MemberPoints {
    V p, gamma, strength_scale;
    V re[max_elements], im[max_elements];
};

struct Rates {
    V bulk;
    V shear[max_elements], half_compliance[max_elements];  // G_k, 1/(2 G_k)
    V strength[max_elements], dilatancy[max_elements];
};

HWY_INLINE V SumOf(const V* v, std::size_t n) {
    V sum = v[0];
    for (std::size_t k = 1; k < n; ++k) sum = hn::Add(sum, v[k]);
    return sum;
}

inline constexpr double log_unit = 9.210340371976184;  // ln 10^4

// Clamped features; returns their largest distance from the trained range.
HWY_INLINE V FeaturesOf(const KernelModel& kernel, const Points& points, const MemberPoints& m, V volume,
                        V log_p, V* x) {
    const Model& model = kernel.model;
    const V re = SumOf(m.re, model.elements), im = SumOf(m.im, model.elements),
            inverse = hn::Div(Set(1), m.p);
    const V e = hn::Sub(hn::Mul(hn::Add(points.e0, Set(1)), volume), Set(1));
    const V s2 = hn::MulAdd(re, re, hn::Mul(im, im));
    const V along = hn::MulAdd(points.fabric_re, re, hn::Mul(points.fabric_im, im));
    x[0] = hn::Mul(Set(1 / 3.0), hn::Sub(log_p, Set(log_unit)));
    x[1] = hn::Mul(hn::Sub(e, Set(0.22)), Set(1 / 0.04));
    x[2] = hn::Mul(hn::Sqrt(hn::MulAdd(s2, hn::Mul(inverse, inverse), Set(1e-4))), Set(1 / 0.4));
    x[3] = hn::Mul(Log(hn::MulAdd(m.gamma, Set(1e3), Set(1))), Set(1 / 3.0));
    x[4] = hn::Mul(Set(1 / 3.0), hn::Sub(points.log_p0, Set(log_unit)));
    x[5] = hn::Mul(hn::Sub(points.e0, Set(0.22)), Set(1 / 0.04));
    x[6] = hn::Mul(hn::Sub(points.coordination, Set(3.5)), Set(1 / 0.5));
    x[7] = hn::Mul(hn::Sub(points.peak_friction, Set(0.5)), Set(1 / 0.1));
    x[8] = hn::Mul(hn::Mul(along, inverse), Set(1 / 0.1));
    V distance = Set(0);
    for (std::size_t i = 0; i < feature_count; ++i) {
        const FeatureRange& range = model.ranges[i];
        const V inside = hn::Clamp(x[i], Set(range.low), Set(range.high));
        distance = hn::Max(distance, hn::Mul(hn::Abs(hn::Sub(x[i], inside)), Set(kernel.inverse_width[i])));
        x[i] = inside;
    }
    return distance;
}

struct Pull {
    V share, toward;
};

// critical_pull of coefficients.hpp.
HWY_INLINE Pull PullOf(const CriticalState& c, const Points& points, const MemberPoints& m, V volume) {
    const V g2 = hn::Mul(m.gamma, m.gamma);
    const V e = hn::Sub(hn::Mul(hn::Add(points.e0, Set(1)), volume), Set(1));
    const V away = hn::MulAdd(Set(c.slope / 1e5), m.p, hn::Sub(e, Set(c.void_ratio)));
    return {hn::Div(g2, hn::Add(g2, Set(c.mature * c.mature))), hn::Mul(Set(-c.pull / 0.04), away)};
}

// G_k, r_k and D_k from the outputs `o`; coefficients() of coefficients.cpp.
HWY_INLINE void ElementRates(const KernelModel& kernel, std::size_t index, V G, V scale, const Pull& pull,
                             const V* HWY_RESTRICT o, Rates& rates) {
    const Model& model = kernel.model;
    const Member& member = model.members[index];
    const std::size_t n = model.elements;
    for (std::size_t k = 0; k < n; ++k) {
        const V share = Set(member.share[k]);
        rates.shear[k] = hn::Mul(hn::Mul(G, share), BoundedFactor(o[k], Set(model.bounds.shear)));
        rates.half_compliance[k] = hn::Div(Set(0.5), rates.shear[k]);
        const V limit = model.frictional ? hn::Mul(Set(member.strength[k]),
                                                   BoundedFactor(o[n + k], Set(model.bounds.strength)))
                                         : Set(never_slips * member.share[k]);
        rates.strength[k] = hn::Mul(scale, limit);
        const V own = hn::Add(Set(member.dilatancy[k]), o[2 * n + k]);
        const V dilatancy = hn::Mul(share, Tanh(hn::MulAdd(pull.share, hn::Sub(pull.toward, own), own)));
        rates.dilatancy[k] = hn::Min(dilatancy, hn::Add(rates.strength[k], rates.strength[k]));
    }
}

// The network's word on the coefficients at this state. Returns the distance from the trained range.
HWY_INLINE V RatesOf(const KernelModel& kernel, std::size_t index, const Points& points,
                     const MemberPoints& m, V volume, Rates& rates) {
    V x[max_width], o[max_width];
    const Member& member = kernel.model.members[index];
    const std::size_t n = kernel.model.elements;
    const V log_p = Log(m.p);
    const V distance = FeaturesOf(kernel, points, m, volume, log_p, x);
    if (member.layers.empty())
        for (std::size_t i = 0; i < 3 * n + 1; ++i) o[i] = Set(0);
    else
        Forward(kernel.layers[index], x, o);
    const V stiffening = Exp(hn::Mul(Set(member.exponent), hn::Sub(log_p, points.log_p0)));
    const V bulk = hn::Mul(Set(member.bulk), BoundedFactor(o[3 * n], Set(kernel.model.bounds.bulk)));
    rates.bulk = hn::Mul(hn::Mul(points.K0, stiffening), bulk);
    ElementRates(kernel, index, hn::Mul(points.G0, stiffening), m.strength_scale,
                 PullOf(member.critical, points, m, volume), o, rates);
    return distance;
}

// solve_pressure of element_update.cpp; `trial` are |T_k|.
HWY_INLINE V SolvePressure(std::size_t n, const Rates& rates, const V* trial, V p_trial, V p_min) {
    V coupling[max_elements];
    for (std::size_t k = 0; k < n; ++k)
        coupling[k] = hn::Mul(hn::Mul(rates.bulk, rates.dilatancy[k]), rates.half_compliance[k]);
    V p = p_trial;
    for (int iteration = 0; iteration < 2; ++iteration) {
        V raised = p_trial, slope = Set(1);
        for (std::size_t k = 0; k < n; ++k) {
            const M slips = hn::Gt(trial[k], hn::Mul(rates.strength[k], p));
            const V c = hn::IfThenElseZero(slips, coupling[k]);
            raised = hn::MulAdd(c, trial[k], raised);
            slope = hn::MulAdd(c, rates.strength[k], slope);
        }
        p = hn::Max(hn::Div(raised, hn::Max(slope, Set(0.1))), p_min);
    }
    return p;
}

// return_map of element_update.cpp: from `old` to `now` (the same is allowed).
HWY_INLINE void ReturnMap(const Model& model, const Member& member, const Points& points, const Rates& rates,
                          V step, const MemberPoints& old, MemberPoints& now) {
    const std::size_t n = model.elements;
    const V p_min = hn::Mul(points.p0, Set(pressure_floor));
    const V re = hn::Mul(points.shear_re, step), im = hn::Mul(points.shear_im, step);
    V trial[max_elements];
    for (std::size_t k = 0; k < n; ++k) {
        const V twice = hn::Add(rates.shear[k], rates.shear[k]);
        now.re[k] = hn::MulAdd(twice, re, old.re[k]);
        now.im[k] = hn::MulAdd(twice, im, old.im[k]);
        trial[k] = hn::Sqrt(hn::MulAdd(now.re[k], now.re[k], hn::MulAdd(now.im[k], now.im[k], Set(1e-12))));
    }
    const V dv = hn::Mul(points.strain_volume, step);
    const V p_trial = hn::Max(hn::MulAdd(rates.bulk, dv, old.p), p_min);
    const V p = SolvePressure(n, rates, trial, p_trial, p_min);
    V gamma = old.gamma;
    for (std::size_t k = 0; k < n; ++k) {
        const V limit = hn::Mul(rates.strength[k], p), beyond = hn::Max(hn::Sub(trial[k], limit), Set(0));
        gamma = hn::MulAdd(hn::Mul(Set(member.share[k]), beyond), rates.half_compliance[k], gamma);
        const V scale = hn::Min(Set(1), hn::Div(limit, trial[k]));
        now.re[k] = hn::Mul(now.re[k], scale);
        now.im[k] = hn::Mul(now.im[k], scale);
    }
    now.p = p;
    now.gamma = gamma;
    now.strength_scale = old.strength_scale;
}

HWY_INLINE void Select(M mask, std::size_t n, const MemberPoints& yes, MemberPoints& state) {
    state.p = hn::IfThenElse(mask, yes.p, state.p);
    state.gamma = hn::IfThenElse(mask, yes.gamma, state.gamma);
    for (std::size_t k = 0; k < n; ++k) {
        state.re[k] = hn::IfThenElse(mask, yes.re[k], state.re[k]);
        state.im[k] = hn::IfThenElse(mask, yes.im[k], state.im[k]);
    }
}

// update_member of point_update.cpp; a point with fewer substeps than its neighbours waits for them.
HWY_INLINE V UpdateMember(const KernelModel& kernel, std::size_t index, const Points& points,
                          MemberPoints& state) {
    const Model& model = kernel.model;
    const Member& member = model.members[index];
    const V step = hn::Div(Set(1), points.substeps), half = hn::Mul(Set(0.5), step);
    const V growth = hn::Mul(hn::Sub(points.determinant, Set(1)), step);
    const auto volume = [&](double i) { return hn::Mul(points.volume, hn::MulAdd(growth, Set(i), Set(1))); };
    V distance = Set(0);
    for (int i = 0; i < points.most_substeps; ++i) {
        Rates rates;
        MemberPoints next;
        RatesOf(kernel, index, points, state, volume(i), rates);
        ReturnMap(model, member, points, rates, half, state, next);
        const V here = RatesOf(kernel, index, points, next, volume(i + 0.5), rates);
        ReturnMap(model, member, points, rates, step, state, next);
        const M active = hn::Lt(Set(i), points.substeps);
        Select(active, model.elements, next, state);
        distance = hn::IfThenElse(active, here, distance);
    }
    return distance;
}

}  // namespace sandgraph::surrogate::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

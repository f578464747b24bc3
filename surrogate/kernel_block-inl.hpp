// A vector of points from memory, through the update, and back; included once per instruction set (no include
// guard by design).
#if defined(SANDGRAPH_SURROGATE_BLOCK_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SANDGRAPH_SURROGATE_BLOCK_INL
#undef SANDGRAPH_SURROGATE_BLOCK_INL
#else
#define SANDGRAPH_SURROGATE_BLOCK_INL
#endif

#include <algorithm>

#include "stress/surrogate.hpp"
#include "surrogate/kernel_update-inl.hpp"
#include "surrogate/state_layout.hpp"

HWY_BEFORE_NAMESPACE();
namespace sandgraph::surrogate::HWY_NAMESPACE {

using DI = hn::RebindToSigned<D>;

// Same numbers of several points, `stride` doubles apart. Missing points repeat the last one, bit for bit.
struct Rows {
    double* base;
    hn::Vec<DI> offset;
    HWY_INLINE V get(std::size_t column) const { return hn::GatherIndex(D(), base + column, offset); }
    HWY_INLINE void set(std::size_t column, V v) const { hn::ScatterIndex(v, D(), base + column, offset); }
};

HWY_INLINE Rows RowsOf(double* base, std::size_t stride, std::span<const std::int32_t> points) {
    HWY_ALIGN std::int64_t offset[8];
    for (std::size_t i = 0; i < hn::Lanes(DI()); ++i)
        offset[i] = static_cast<std::int64_t>(stride) * points[std::min(i, points.size() - 1)];
    return {base, hn::Load(DI(), offset)};
}

// stress::increment and strain_of, in their order of operations.
HWY_INLINE void SetStrain(const Rows& F, double substep, Points& points) {
    const V one = Set(1), half = Set(0.5);
    const V xx = F.get(0), yx = F.get(1), xy = F.get(2), yy = F.get(3);
    const V a = hn::Add(xx, yy), b = hn::Sub(yx, xy);
    const V n = hn::Div(one, hn::Sqrt(hn::Add(hn::Mul(a, a), hn::Mul(b, b))));
    const V c = hn::Mul(a, n), s = hn::Mul(b, n);
    const V uxx = hn::Sub(hn::Add(hn::Mul(c, xx), hn::Mul(s, yx)), one);
    const V uyy = hn::Sub(hn::Sub(hn::Mul(c, yy), hn::Mul(s, xy)), one);
    const V uxy = hn::Mul(half, hn::Add(hn::Mul(c, hn::Add(xy, yx)), hn::Mul(s, hn::Sub(yy, xx))));
    const V vxx = hn::Add(uxx, Set(2)), vyy = hn::Add(uyy, Set(2)), u2 = hn::Mul(uxy, uxy);
    const V k = hn::Div(Set(2), hn::Sub(hn::Mul(vxx, vyy), u2));
    const V exx = hn::Mul(k, hn::Sub(hn::Mul(uxx, vyy), u2)),
            eyy = hn::Mul(k, hn::Sub(hn::Mul(uyy, vxx), u2));
    points.shear_re = hn::Mul(Set(-0.5), hn::Sub(exx, eyy));
    points.shear_im = hn::Neg(hn::Mul(hn::Mul(k, Set(2)), uxy));
    points.strain_volume = hn::Neg(hn::Add(exx, eyy));
    points.determinant = hn::Sub(hn::Mul(xx, yy), hn::Mul(xy, yx));
    points.cos2 = hn::Sub(hn::Mul(c, c), hn::Mul(s, s));
    points.sin2 = hn::Mul(hn::Mul(Set(2), c), s);
    const V shear = hn::Sqrt(
        hn::Add(hn::Mul(points.shear_re, points.shear_re), hn::Mul(points.shear_im, points.shear_im)));
    const V largest = hn::Max(shear, hn::Abs(points.strain_volume));
    points.substeps = hn::Clamp(hn::Ceil(hn::Div(largest, Set(substep))), one, Set(1000));
    points.most_substeps = static_cast<int>(hn::GetLane(hn::MaxOfLanes(D(), points.substeps)));
}

HWY_INLINE Points Fetch(const Rows& state) {
    const std::size_t c = StateLayout::constants;
    Points p;
    p.volume = state.get(StateLayout::volume);
    p.fabric_re = state.get(StateLayout::fabric);
    p.fabric_im = state.get(StateLayout::fabric + 1);
    p.p0 = state.get(c), p.e0 = state.get(c + 1), p.K0 = state.get(c + 2);
    p.G0 = state.get(c + 3), p.coordination = state.get(c + 4), p.strength = state.get(c + 5);
    p.log_p0 = Log(p.p0);
    return p;
}

HWY_INLINE MemberPoints FetchMember(const Rows& state, std::size_t first, std::size_t n) {
    MemberPoints m;
    m.p = state.get(first), m.gamma = state.get(first + 1), m.strength_scale = state.get(first + 2);
    for (std::size_t k = 0; k < n; ++k) {
        m.re[k] = state.get(first + 3 + k);
        m.im[k] = state.get(first + 3 + n + k);
    }
    return m;
}

// The rotation of the increment turns the deviators; the strength scale stays as it is.
HWY_INLINE void StoreMember(const Rows& state, std::size_t first, std::size_t n, const Points& points,
                            MemberPoints& m) {
    state.set(first, m.p);
    state.set(first + 1, m.gamma);
    for (std::size_t k = 0; k < n; ++k) {
        const V re = m.re[k], im = m.im[k];
        m.re[k] = hn::Sub(hn::Mul(re, points.cos2), hn::Mul(im, points.sin2));
        m.im[k] = hn::Add(hn::Mul(re, points.sin2), hn::Mul(im, points.cos2));
        state.set(first + 3 + k, m.re[k]);
        state.set(first + 3 + n + k, m.im[k]);
    }
}

HWY_INLINE void StorePoints(const Rows& state, const Points& p) {
    state.set(StateLayout::volume, hn::Mul(p.volume, p.determinant));
    state.set(StateLayout::fabric, hn::Sub(hn::Mul(p.fabric_re, p.cos2), hn::Mul(p.fabric_im, p.sin2)));
    state.set(StateLayout::fabric + 1, hn::Add(hn::Mul(p.fabric_re, p.sin2), hn::Mul(p.fabric_im, p.cos2)));
}

// Members' stresses -> mean, spread; as answer_of in point_update.cpp.
struct MemberStress {
    V p[max_members], re[max_members], im[max_members];
};

HWY_INLINE void StoreAnswers(const MemberStress& s, std::size_t members, V distance,
                             std::span<stress::SurrogateAnswer> answers) {
    const D d;
    const V share = Set(1 / static_cast<double>(members));
    const V p = hn::Mul(SumOf(s.p, members), share);
    const V re = hn::Mul(SumOf(s.re, members), share), im = hn::Mul(SumOf(s.im, members), share);
    V square = Set(0);
    for (std::size_t m = 0; m < members; ++m) {
        const V dp = hn::Sub(s.p[m], p), dr = hn::Sub(s.re[m], re), di = hn::Sub(s.im[m], im);
        square = hn::MulAdd(dp, dp, hn::MulAdd(dr, dr, hn::MulAdd(di, di, square)));
    }
    const V spread = hn::Div(hn::Sqrt(hn::Mul(hn::Add(share, share), square)), hn::Max(p, Set(1e3)));
    HWY_ALIGN double out[5][8];
    hn::Store(hn::Neg(hn::Add(p, re)), d, out[0]);
    hn::Store(hn::Sub(re, p), d, out[1]);
    hn::Store(hn::Neg(im), d, out[2]);
    hn::Store(spread, d, out[3]);
    hn::Store(distance, d, out[4]);
    for (std::size_t i = 0; i < answers.size(); ++i)
        answers[i] = {{out[0][i], out[1][i], out[2][i]}, out[3][i], out[4][i]};
}

// Up to one vector of points.
HWY_INLINE void ServeBlock(const Model& model, const Rows& state, const Rows& F,
                           std::span<stress::SurrogateAnswer> answers) {
    const StateLayout layout{model.elements, model.members.size()};
    Points points = Fetch(state);
    SetStrain(F, model.substep, points);
    MemberStress stresses;
    V distance = Set(0);
    for (std::size_t m = 0; m < layout.members; ++m) {
        MemberPoints member = FetchMember(state, layout.member(m), layout.elements);
        distance = hn::Max(distance, UpdateMember(model, model.members[m], points, member));
        StoreMember(state, layout.member(m), layout.elements, points, member);
        stresses.p[m] = member.p;
        stresses.re[m] = SumOf(member.re, layout.elements);
        stresses.im[m] = SumOf(member.im, layout.elements);
    }
    StorePoints(state, points);
    // An increment that is no number says so.
    distance = hn::Add(distance, hn::Mul(Set(0), points.determinant));
    StoreAnswers(stresses, layout.members, distance, answers);
}

void Serve(const Model& model, std::span<const std::int32_t> points, std::span<const Mat2> F_inc,
           std::span<double> states, std::span<stress::SurrogateAnswer> answers) {
    const StateLayout layout{model.elements, model.members.size()};
    double* increments = const_cast<double*>(F_inc.front().data());  // Rows only reads them
    const std::size_t lanes = hn::Lanes(D());
    for (std::size_t i = 0; i < points.size(); i += lanes) {
        const auto block = points.subspan(i, std::min(lanes, points.size() - i));
        ServeBlock(model, RowsOf(states.data(), layout.size(), block), RowsOf(increments, 4, block),
                   answers.subspan(i, block.size()));
    }
}

const char* TargetName() { return hwy::TargetName(HWY_TARGET); }

}  // namespace sandgraph::surrogate::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

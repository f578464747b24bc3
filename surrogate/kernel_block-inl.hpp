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

// Rows of doubles in memory, one a point, as columns of vectors. All rows are staged first, four doubles of
// every point after another, so that Highway turns them into columns without waiting for a store. Missing
// points repeat the last one, bit for bit, and are not stored.
struct Rows {
    double* base;
    std::size_t stride, count;
    const std::int32_t* points;
    double* HWY_RESTRICT stage;  // [stride x lanes], aligned

    HWY_INLINE double* at(std::size_t lane) const {
        return base + stride * static_cast<std::size_t>(points[std::min(lane, count - 1)]);
    }
    HWY_INLINE void fetch() const {
        const D4 four;
        const std::size_t lanes = hn::Lanes(D());
        for (std::size_t i = 0; i < lanes; ++i)
            for (std::size_t c = 0; c < stride; c += 4)
                for (std::size_t k = 0; k < 4; k += hn::Lanes(four))
                    hn::Store(hn::LoadU(four, at(i) + c + k), four, stage + c * lanes + 4 * i + k);
    }
    HWY_INLINE void store() const {
        const D4 four;
        const std::size_t lanes = hn::Lanes(D());
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t c = 0; c < stride; c += 4)
                for (std::size_t k = 0; k < 4; k += hn::Lanes(four))
                    hn::StoreU(hn::Load(four, stage + c * lanes + 4 * i + k), four, at(i) + c + k);
    }
    HWY_INLINE void get4(std::size_t column, V* v) const {
        hn::LoadInterleaved4(D(), stage + column * hn::Lanes(D()), v[0], v[1], v[2], v[3]);
    }
    HWY_INLINE void set4(std::size_t column, const V* v) const {
        hn::StoreInterleaved4(v[0], v[1], v[2], v[3], D(), stage + column * hn::Lanes(D()));
    }
};

// stress::increment and strain_of, in their order of operations.
HWY_INLINE void SetStrain(const Rows& F, double substep, Points& points) {
    const V one = Set(1), half = Set(0.5);
    V column[4];  // Eigen keeps columns
    F.get4(0, column);
    const V xx = column[0], yx = column[1], xy = column[2], yy = column[3];
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
    static_assert(StateLayout::volume == 0 && StateLayout::fabric == 1 && StateLayout::constants == 3);
    V v[StateLayout::shared];
    for (std::size_t c = 0; c < StateLayout::shared; c += 4) state.get4(c, v + c);
    Points p;
    p.volume = v[0], p.fabric_re = v[1], p.fabric_im = v[2];
    p.p0 = v[3], p.e0 = v[4], p.K0 = v[5], p.G0 = v[6], p.coordination = v[7], p.peak_friction = v[8];
    p.log_p0 = Log(p.p0);
    return p;
}

// The rotation of the increment turns the fabric.
HWY_INLINE void StorePoints(const Rows& state, const Points& p) {
    const V v[4] = {hn::Mul(p.volume, p.determinant),
                    hn::Sub(hn::Mul(p.fabric_re, p.cos2), hn::Mul(p.fabric_im, p.sin2)),
                    hn::Add(hn::Mul(p.fabric_re, p.sin2), hn::Mul(p.fabric_im, p.cos2)), p.p0};
    state.set4(0, v);
}

using MemberColumns = V[3 + 2 * max_elements + 4];

HWY_INLINE MemberPoints FetchMember(const Rows& state, const StateLayout& layout, std::size_t index) {
    MemberColumns v;
    const std::size_t n = layout.elements;
    for (std::size_t c = 0; c < layout.member_size(); c += 4) state.get4(layout.member(index) + c, v + c);
    MemberPoints m;
    m.p = v[0], m.gamma = v[1], m.strength_scale = v[2];
    for (std::size_t k = 0; k < n; ++k) m.re[k] = v[3 + k], m.im[k] = v[3 + n + k];
    return m;
}

HWY_INLINE void StoreMember(const Rows& state, const StateLayout& layout, std::size_t index,
                            const MemberPoints& m) {
    MemberColumns v;
    const std::size_t n = layout.elements;
    v[0] = m.p, v[1] = m.gamma, v[2] = m.strength_scale;
    for (std::size_t k = 0; k < n; ++k) v[3 + k] = m.re[k], v[3 + n + k] = m.im[k];
    for (std::size_t c = 3 + 2 * n; c < layout.member_size(); ++c) v[c] = Set(0);
    for (std::size_t c = 0; c < layout.member_size(); c += 4) state.set4(layout.member(index) + c, v + c);
}

// The rotation of the increment turns the deviators.
HWY_INLINE void Turn(const Points& points, std::size_t n, MemberPoints& m) {
    for (std::size_t k = 0; k < n; ++k) {
        const V re = m.re[k], im = m.im[k];
        m.re[k] = hn::Sub(hn::Mul(re, points.cos2), hn::Mul(im, points.sin2));
        m.im[k] = hn::Add(hn::Mul(re, points.sin2), hn::Mul(im, points.cos2));
    }
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
HWY_INLINE void ServeBlock(const KernelModel& kernel, const Rows& state, const Rows& F,
                           std::span<stress::SurrogateAnswer> answers) {
    const StateLayout& layout = kernel.layout;
    state.fetch();
    F.fetch();
    Points points = Fetch(state);
    SetStrain(F, kernel.model.substep, points);
    MemberStress stresses;
    V distance = Set(0);
    for (std::size_t m = 0; m < layout.members; ++m) {
        MemberPoints member = FetchMember(state, layout, m);
        distance = hn::Max(distance, UpdateMember(kernel, m, points, member));
        Turn(points, layout.elements, member);
        StoreMember(state, layout, m, member);
        stresses.p[m] = member.p;
        stresses.re[m] = SumOf(member.re, layout.elements);
        stresses.im[m] = SumOf(member.im, layout.elements);
    }
    StorePoints(state, points);
    state.store();
    // An increment that is no number says so.
    distance = hn::Add(distance, hn::Mul(Set(0), points.determinant));
    StoreAnswers(stresses, layout.members, distance, answers);
}

void Serve(const KernelModel& kernel, std::span<const std::int32_t> points, std::span<const Mat2> F_inc,
           std::span<double> states, std::span<stress::SurrogateAnswer> answers) {
    double* increments = const_cast<double*>(F_inc.front().data());  // Rows only reads them
    HWY_ALIGN double stage[max_state * 8], increment_stage[4 * 8];
    const std::size_t lanes = hn::Lanes(D());
    for (std::size_t i = 0; i < points.size(); i += lanes) {
        const std::size_t count = std::min(lanes, points.size() - i);
        ServeBlock(kernel, {states.data(), kernel.layout.size(), count, &points[i], stage},
                   {increments, 4, count, &points[i], increment_stage}, answers.subspan(i, count));
    }
}

const char* TargetName() { return hwy::TargetName(HWY_TARGET); }

}  // namespace sandgraph::surrogate::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

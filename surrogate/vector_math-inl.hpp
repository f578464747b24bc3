// Functions of the kernel; included once per instruction set (no include guard by design).
#if defined(SANDGRAPH_SURROGATE_MATH_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SANDGRAPH_SURROGATE_MATH_INL
#undef SANDGRAPH_SURROGATE_MATH_INL
#else
#define SANDGRAPH_SURROGATE_MATH_INL
#endif

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace sandgraph::surrogate::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<double, 8>;
using D4 = hn::CappedTag<double, 4>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;

HWY_INLINE V Set(double x) { return hn::Set(D(), x); }

struct Fraction {
    V over, under;  // under > 0
};

// exp(x) = over/under for |x| <= 600, relative error below 1e-16 (3 + |x|). With x = k ln 2 + r it is
// 2^k (Q + r)/(Q - r), Q = r coth(r/2), a series in r^2.
HWY_INLINE Fraction ExpFraction(V x) {
    const D d;
    const hn::RebindToUnsigned<D> du;
    const V round = Set(0x1.8p52);
    const V shifted = hn::MulAdd(x, Set(1.4426950408889634), round);
    const V k = hn::Sub(shifted, round);
    const V r = hn::NegMulAdd(k, Set(0.6931471805599453), x);
    const V z = hn::Mul(r, r);
    V q = hn::MulAdd(z, Set(-691 / 653837184000.0), Set(1 / 23950080.0));
    q = hn::MulAdd(q, z, Set(-1 / 604800.0));
    q = hn::MulAdd(q, z, Set(1 / 15120.0));
    q = hn::MulAdd(q, z, Set(-1 / 360.0));
    q = hn::MulAdd(q, z, Set(1 / 6.0));
    q = hn::MulAdd(q, z, Set(2.0));
    // The low bits of `shifted` are k: added to the exponent.
    const auto exponent = hn::ShiftLeft<52>(hn::BitCast(du, shifted));
    return {hn::BitCast(d, hn::Add(hn::BitCast(du, hn::Add(q, r)), exponent)), hn::Sub(q, r)};
}

HWY_INLINE V Exp(V x) {
    const Fraction e = ExpFraction(x);
    return hn::Div(e.over, e.under);
}

// Absolute error below 1e-15.
HWY_INLINE V Tanh(V x) {
    const Fraction e = ExpFraction(hn::Clamp(hn::Add(x, x), Set(-40), Set(40)));
    return hn::Div(hn::Sub(e.over, e.under), hn::Add(e.over, e.under));
}

// bounded_factor(o, b), relative error below 1e-15.
HWY_INLINE V BoundedFactor(V o, V b) {
    const Fraction e = ExpFraction(hn::Clamp(o, Set(-40), Set(40)));
    return hn::Div(hn::MulAdd(b, e.over, e.under), hn::MulAdd(b, e.under, e.over));
}

HWY_INLINE V Log(V x) { return hn::Log(D(), x); }

}  // namespace sandgraph::surrogate::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

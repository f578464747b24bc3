// Search of near pairs for the mixed-precision kernel; included once per instruction set (no include guard by
// design).
#if defined(SANDGRAPH_MIXED_SEARCH_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SANDGRAPH_MIXED_SEARCH_INL
#undef SANDGRAPH_MIXED_SEARCH_INL
#else
#define SANDGRAPH_MIXED_SEARCH_INL
#endif

#include <vector>

#include "dem/fast/neighbours.hpp"
#include "dem/mixed/forces-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sandgraph::dem::HWY_NAMESPACE::mixed {

// Grains [j, j + kLanes) against grain i: a bit for each that is near.
HWY_INLINE unsigned Near(const MixedPacking& p, const float* reach, const Tensor& cell, int i, int j) {
    const D d;
    const DI di;
    const V a = hn::ConvertTo(d, hn::Sub(hn::Load(di, p.x.data() + j), hn::Set(di, p.x[i]))),
            b = hn::ConvertTo(d, hn::Sub(hn::Load(di, p.y.data() + j), hn::Set(di, p.y[i])));
    const V dx = cell.x(a, b), dy = cell.y(a, b),
            most = hn::Add(hn::Load(d, reach + j), hn::Set(d, reach[i]));
    const auto near = hn::Lt(hn::MulAdd(dx, dx, hn::Mul(dy, dy)), hn::Mul(most, most));
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, near, bytes);
    return bytes[0] | unsigned{bytes[1]} << 8;
}

void Search(const MixedPacking& p, const float* reach, std::vector<NearPair>& pairs) {
    const Tensor cell(kUnit * p.H);
    pairs.clear();
    for (int i = 0; i < p.grains; ++i)
        for (int block = (i + 1) / kLanes * kLanes; block < p.grains; block += kLanes)
            for (unsigned near = Near(p, reach, cell, i, block); near != 0; near &= near - 1) {
                const int j = block + __builtin_ctz(near);
                if (j > i && j < p.grains) pairs.push_back({i, j, 0, 0});
            }
}

}  // namespace sandgraph::dem::HWY_NAMESPACE::mixed
HWY_AFTER_NAMESPACE();
#endif

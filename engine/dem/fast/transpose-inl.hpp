// Rows of four numbers to columns and back; included once per instruction set (no include guard by design).
#if defined(SANDGRAPH_FAST_TRANSPOSE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SANDGRAPH_FAST_TRANSPOSE_INL
#undef SANDGRAPH_FAST_TRANSPOSE_INL
#else
#define SANDGRAPH_FAST_TRANSPOSE_INL
#endif

#include "dem/fast/state.hpp"

HWY_BEFORE_NAMESPACE();
namespace sandgraph::dem::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Lanes are capped at FastState::kLanes, the padding of every array.
using D = hn::CappedTag<double, FastState::kLanes>;
using V = hn::Vec<D>;
using D4 = hn::CappedTag<double, 4>;

#if HWY_MAX_BYTES == 64

// Shuffles of whole vectors are what a machine has fewest ports for; so rows are joined on their way from
// memory, which needs none, and Highway's own (interleaved) loads and stores take twice as many.

// Four numbers at `a` and four at `b`.
HWY_INLINE V Join(const double* a, const double* b) {
    return V{_mm512_insertf64x4(_mm512_castpd256_pd512(_mm256_load_pd(a)), _mm256_load_pd(b), 1)};
}

// The row, of eight, in the lower half of joined row k; the one two rows on is in the upper half.
constexpr int JoinedRow(int k) { return k + k / 2 * 2; }

// Four joined rows to the columns of the eight.
HWY_INLINE void Columns(const V* joined, V* column) {
    const D d;
    for (int odd = 0; odd < 2; ++odd) {
        const auto pick = [&](const V* v) HWY_ATTR {
            return odd ? hn::InterleaveUpper(d, v[0], v[1]) : hn::InterleaveLower(d, v[0], v[1]);
        };
        const V first = pick(joined), last = pick(joined + 2);
        column[odd] = V{_mm512_shuffle_f64x2(first.raw, last.raw, 0x88)};
        column[odd + 2] = V{_mm512_shuffle_f64x2(first.raw, last.raw, 0xDD)};
    }
}

// Columns to the eight rows, `stride` numbers apart.
HWY_INLINE void StoreRows(V c0, V c1, V c2, V c3, double* row, std::size_t stride) {
    const D d;
    const __m512i near = _mm512_setr_epi64(0, 1, 8, 9, 2, 3, 10, 11),
                  far = _mm512_setr_epi64(4, 5, 12, 13, 6, 7, 14, 15);
    for (std::size_t odd = 0; odd < 2; ++odd) {
        const V front = odd ? hn::InterleaveUpper(d, c0, c1) : hn::InterleaveLower(d, c0, c1),
                back = odd ? hn::InterleaveUpper(d, c2, c3) : hn::InterleaveLower(d, c2, c3);
        const __m512d rows02 = _mm512_permutex2var_pd(front.raw, near, back.raw),
                      rows46 = _mm512_permutex2var_pd(front.raw, far, back.raw);
        _mm256_store_pd(row + odd * stride, _mm512_castpd512_pd256(rows02));
        _mm256_store_pd(row + (odd + 2) * stride, _mm512_extractf64x4_pd(rows02, 1));
        _mm256_store_pd(row + (odd + 4) * stride, _mm512_castpd512_pd256(rows46));
        _mm256_store_pd(row + (odd + 6) * stride, _mm512_extractf64x4_pd(rows46, 1));
    }
}

#endif

}  // namespace sandgraph::dem::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

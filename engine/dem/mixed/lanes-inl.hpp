// Vectors of grains and pairs for the mixed-precision kernel; included once per instruction set (no include
// guard by design).
#if defined(SANDGRAPH_MIXED_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SANDGRAPH_MIXED_LANES_INL
#undef SANDGRAPH_MIXED_LANES_INL
#else
#define SANDGRAPH_MIXED_LANES_INL
#endif

#include "dem/mixed/state.hpp"

HWY_BEFORE_NAMESPACE();
namespace sandgraph::dem::HWY_NAMESPACE::mixed {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<float, MixedPacking::kLanes>;
using DI = hn::RebindToSigned<D>;
using V = hn::Vec<D>;
using VI = hn::Vec<DI>;
inline constexpr int kLanes = HWY_MIN(int(hn::MaxLanes(D())), MixedPacking::kLanes);
inline constexpr int kRecord = 8, kForce = 4;  // numbers of a grain by place

// Six columns of the records of kLanes partners.
struct Partners {
    VI x, y;
    V u, v, w, r;
};

#if HWY_TARGET == HWY_SCALAR

HWY_INLINE void Transpose(const V* row, V* column) {
    for (int k = 0; k < 4; ++k) column[k] = row[k];
}
HWY_INLINE Partners LoadPartners(const float* record, const std::uint16_t* place) {
    const D d;
    const float* a = record + kRecord * std::size_t{place[0]};
    return {hn::BitCast(DI(), hn::Load(d, a)),
            hn::BitCast(DI(), hn::Load(d, a + 1)),
            hn::Load(d, a + 2),
            hn::Load(d, a + 3),
            hn::Load(d, a + 4),
            hn::Load(d, a + 5)};
}
// Rows of four that lie side by side at `row`, as columns.
HWY_INLINE void LoadColumns(const float* row, V* column) {
    for (int k = 0; k < 4; ++k) column[k] = hn::Load(D(), row + k);
}
HWY_INLINE void StoreRecords(const V* first, const V* last, float* record) {
    for (int k = 0; k < 4; ++k) hn::Store(first[k], D(), record + k), hn::Store(last[k], D(), record + 4 + k);
}

#else

// 4 x 4 in every quarter (128 bits) of the vectors; its own inverse.
HWY_INLINE void Transpose(const V* row, V* column) {
    const D d;
    const hn::RepartitionToWide<D> w;
    for (int high = 0; high < 2; ++high) {
        const auto zip = [&](V a, V b) HWY_ATTR {
            return hn::BitCast(w, high ? hn::InterleaveUpper(d, a, b) : hn::InterleaveLower(d, a, b));
        };
        const auto a = zip(row[0], row[1]), b = zip(row[2], row[3]);
        column[2 * high] = hn::BitCast(d, hn::InterleaveLower(w, a, b));
        column[2 * high + 1] = hn::BitCast(d, hn::InterleaveUpper(w, a, b));
    }
}

#if HWY_MAX_BYTES == 64

HWY_INLINE V Join(const float* a, const float* b) {
    const __m512d lower = _mm512_castpd256_pd512(_mm256_castps_pd(_mm256_load_ps(a)));
    return V{_mm512_castpd_ps(_mm512_insertf64x4(lower, _mm256_castps_pd(_mm256_load_ps(b)), 1))};
}

// Whole records, two a vector; after the transposition first halves lie in the even quarters.
HWY_INLINE Partners LoadPartners(const float* record, const std::uint16_t* place) {
    V column[2][4];
    for (int half = 0; half < 2; ++half) {
        V row[4];
        for (int k = 0; k < 4; ++k)
            row[k] = Join(record + kRecord * std::size_t{place[8 * half + k]},
                          record + kRecord * std::size_t{place[8 * half + k + 4]});
        Transpose(row, column[half]);
    }
    const auto even = [&](int k) HWY_ATTR {
        return V{_mm512_shuffle_f32x4(column[0][k].raw, column[1][k].raw, 0x88)};
    };
    const auto odd = [&](int k) HWY_ATTR {
        return V{_mm512_shuffle_f32x4(column[0][k].raw, column[1][k].raw, 0xDD)};
    };
    return {hn::BitCast(DI(), even(0)), hn::BitCast(DI(), even(1)), even(2), even(3), odd(0), odd(1)};
}

HWY_INLINE void StoreRecords(const V* first, const V* last, float* record) {
    const __m512i near = _mm512_setr_epi64(0, 1, 8, 9, 2, 3, 10, 11),
                  far = _mm512_setr_epi64(4, 5, 12, 13, 6, 7, 14, 15);
    V a[4], b[4];
    Transpose(first, a), Transpose(last, b);
    for (int k = 0; k < 4; ++k) {
        const __m512d p = _mm512_castps_pd(a[k].raw), q = _mm512_castps_pd(b[k].raw);
        float* out = record + kRecord * 4 * k;
        _mm512_store_ps(out, _mm512_castpd_ps(_mm512_permutex2var_pd(p, near, q)));
        _mm512_store_ps(out + 2 * kRecord, _mm512_castpd_ps(_mm512_permutex2var_pd(p, far, q)));
    }
}

#else

using D4 = hn::CappedTag<float, 4>;

// Numbers [k, k + 4) of the records of the partners of lanes l, l + 4, ...
HWY_INLINE V Joined(const float* record, const std::uint16_t* place, int l, int k) {
    const auto half = [&](int lane) HWY_ATTR {
        return hn::Load(D4(), record + kRecord * std::size_t{place[lane]} + k);
    };
#if HWY_MAX_BYTES == 32
    return hn::Combine(D(), half(l + 4), half(l));
#else
    return half(l);
#endif
}

HWY_INLINE Partners LoadPartners(const float* record, const std::uint16_t* place) {
    V row[4], first[4], last[4];
    for (int l = 0; l < 4; ++l) row[l] = Joined(record, place, l, 0);
    Transpose(row, first);
    for (int l = 0; l < 4; ++l) row[l] = Joined(record, place, l, 4);
    Transpose(row, last);
    return {hn::BitCast(DI(), first[0]), hn::BitCast(DI(), first[1]), first[2], first[3], last[0], last[1]};
}

// Places 4 k + quarter of the block that `record` begins in.
HWY_INLINE void StoreRecords(const V* first, const V* last, float* record) {
    V a[4], b[4];
    Transpose(first, a), Transpose(last, b);
    for (int k = 0; k < 4; ++k) {
        float* out = record + kRecord * 4 * k;
#if HWY_MAX_BYTES == 32
        hn::Store(hn::ConcatLowerLower(D(), b[k], a[k]), D(), out);
        hn::Store(hn::ConcatUpperUpper(D(), b[k], a[k]), D(), out + kRecord);
#else
        hn::Store(a[k], D(), out), hn::Store(b[k], D(), out + 4);
#endif
    }
}

#endif

HWY_INLINE void LoadColumns(const float* row, V* column) {
    V rows[4];
    for (int k = 0; k < 4; ++k) rows[k] = hn::Load(D(), row + kForce * 4 * k);
    Transpose(rows, column);
}

#endif

// Where the part of a block of grains that starts at grain g begins among the places.
constexpr std::size_t FirstPlace(int g) { return static_cast<std::size_t>(place_of(g)); }

}  // namespace sandgraph::dem::HWY_NAMESPACE::mixed
HWY_AFTER_NAMESPACE();
#endif

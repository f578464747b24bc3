// Pairs side by side for the fast kernel; included once per instruction set (no include guard by design).
#if defined(SANDGRAPH_FAST_PAIRS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SANDGRAPH_FAST_PAIRS_INL
#undef SANDGRAPH_FAST_PAIRS_INL
#else
#define SANDGRAPH_FAST_PAIRS_INL
#endif

#include "dem/fast_state.hpp"

HWY_BEFORE_NAMESPACE();
namespace sandgraph::dem::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Lanes are capped at FastState::kLanes, the padding of every array.
using D = hn::CappedTag<double, FastState::kLanes>;
using V = hn::Vec<D>;
using D4 = hn::CappedTag<double, 4>;

inline constexpr int kBlock = 64;  // pairs at a time between law and scatter: the buffers stay in L1
inline constexpr int kRecord = FastState::kRecord;
inline constexpr bool kWholeRecords = HWY_MAX_BYTES == 64;  // a vector holds a record

// Image offsets: H c and L H_old c for the nine neighbouring cells, as records to add to that of j.
struct ImageTable {
    alignas(64) double shift[kRecord * 9] = {};
    explicit ImageTable(const FastState& s) {
        for (int image = 0; image < 9; ++image) {
            const Vec2 c(image / 3 - 1, image % 3 - 1);
            const Vec2 position = s.H * c, velocity = s.LH * c;
            double* out = shift + kRecord * image;
            out[0] = position.x(), out[1] = position.y(), out[2] = velocity.x(), out[3] = velocity.y();
        }
    }
};

// The arrays of a state as local pointers: vector stores may alias anything, members would be reloaded each
// time.
struct Arrays {
    const double* HWY_RESTRICT record;
    double* HWY_RESTRICT force;
    const std::uint16_t *HWY_RESTRICT i, *HWY_RESTRICT j;
    const std::uint8_t* HWY_RESTRICT image;
    double *HWY_RESTRICT tangential, *HWY_RESTRICT moment;
    explicit Arrays(FastState& s)
        : record(s.record.data()),
          force(s.force.data()),
          i(s.i.data()),
          j(s.j.data()),
          image(s.image.data()),
          tangential(s.tangential.data()),
          moment(s.moment.data()) {}
};

// N pairs side by side: the image of j seen from i, r_i + r_j, r_i w_i + r_j w_j, w_j - w_i, r_j - r_i.
struct Lanes {
    V dx, dy, dvx, dvy, r_sum, rw_sum, dw, r_diff;
};

// `geometry` and `rotation` hold the two halves of the records of pairs where lanes are narrower than a
// record.
struct PairBuffers {
    alignas(64) double geometry[kWholeRecords ? 1 : 4 * kBlock];
    alignas(64) double rotation[kWholeRecords ? 1 : 4 * kBlock];
    alignas(64) double force[4 * kBlock];
};

// Sign of i in the record of a pair.
alignas(64) inline constexpr double kSign[kRecord] = {-1, -1, -1, -1, 1, 1, -1, -1};

// Numbers [k, k + lanes) of the record of pair c.
template <bool kWrapped>
HWY_INLINE V PairRecord(const Arrays& s, const ImageTable& images, int c, std::size_t k) {
    const D d;
    const double *i = s.record + std::size_t{kRecord} * s.i[c] + k,
                 *j = s.record + std::size_t{kRecord} * s.j[c] + k;
    const V pair = hn::MulAdd(hn::Load(d, kSign + k), hn::Load(d, i), hn::Load(d, j));
    if constexpr (!kWrapped) return pair;
    return hn::Add(pair, hn::Load(d, images.shift + std::size_t{kRecord} * s.image[c] + k));
}

#if HWY_MAX_BYTES == 64

// Four vectors of four blocks to the vectors of their first, second, third and fourth blocks. Highway has no
// two-operand shuffle of blocks, and blends instead would cost a tenth of the loop.
HWY_INLINE void TransposeBlocks(V a, V b, V c, V e, V* out) {
    const __m512d ab = _mm512_shuffle_f64x2(a.raw, b.raw, 0x44),
                  ab_upper = _mm512_shuffle_f64x2(a.raw, b.raw, 0xEE);
    const __m512d ce = _mm512_shuffle_f64x2(c.raw, e.raw, 0x44),
                  ce_upper = _mm512_shuffle_f64x2(c.raw, e.raw, 0xEE);
    out[0] = V{_mm512_shuffle_f64x2(ab, ce, 0x88)}, out[2] = V{_mm512_shuffle_f64x2(ab, ce, 0xDD)};
    out[4] = V{_mm512_shuffle_f64x2(ab_upper, ce_upper, 0x88)},
    out[6] = V{_mm512_shuffle_f64x2(ab_upper, ce_upper, 0xDD)};
}

// Eight rows of eight to columns, or back.
HWY_INLINE void Transpose(const V* row, V* column) {
    const D d;
    TransposeBlocks(hn::InterleaveLower(d, row[0], row[1]), hn::InterleaveLower(d, row[2], row[3]),
                    hn::InterleaveLower(d, row[4], row[5]), hn::InterleaveLower(d, row[6], row[7]), column);
    TransposeBlocks(hn::InterleaveUpper(d, row[0], row[1]), hn::InterleaveUpper(d, row[2], row[3]),
                    hn::InterleaveUpper(d, row[4], row[5]), hn::InterleaveUpper(d, row[6], row[7]),
                    column + 1);
}

template <bool kWrapped>
struct PairSource {
    const Arrays& s;
    const ImageTable& images;
    int first;
    PairSource(const Arrays& arrays, const ImageTable& table, int begin, int, PairBuffers&)
        : s(arrays), images(table), first(begin) {}
    HWY_INLINE Lanes Load(int c) const {
        V row[8], column[8];
        for (int k = 0; k < 8; ++k) row[k] = PairRecord<kWrapped>(s, images, first + c + k, 0);
        Transpose(row, column);
        return {column[0], column[1], column[2], column[3], column[4], column[5], column[6], column[7]};
    }
};

#else

template <bool kWrapped>
struct PairSource {
    const PairBuffers& buffers;
    PairSource(const Arrays& s, const ImageTable& images, int first, int count, PairBuffers& out)
        : buffers(out) {
        const D4 d;
        for (int c = 0; c < count; ++c)
            for (std::size_t k = 0; k < 4; k += hn::Lanes(d)) {
                hn::Store(PairRecord<kWrapped>(s, images, first + c, k), d, out.geometry + 4 * c + k);
                hn::Store(PairRecord<kWrapped>(s, images, first + c, 4 + k), d, out.rotation + 4 * c + k);
            }
    }
    HWY_INLINE Lanes Load(int c) const {
        Lanes p;
        hn::LoadInterleaved4(D(), buffers.geometry + 4 * c, p.dx, p.dy, p.dvx, p.dvy);
        hn::LoadInterleaved4(D(), buffers.rotation + 4 * c, p.r_sum, p.rw_sum, p.dw, p.r_diff);
        return p;
    }
};

#endif

}  // namespace sandgraph::dem::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

// Pairs side by side for the fast kernel; included once per instruction set (no include guard by design).
#if defined(SANDGRAPH_FAST_PAIRS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SANDGRAPH_FAST_PAIRS_INL
#undef SANDGRAPH_FAST_PAIRS_INL
#else
#define SANDGRAPH_FAST_PAIRS_INL
#endif

#include "dem/fast/transpose-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sandgraph::dem::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

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

// Numbers [k, k + lanes) of the record of pair c, where a vector holds no more than half a record.
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

template <bool kWrapped>
struct PairSource {
    const Arrays& s;
    const ImageTable& images;
    int first;
    PairSource(const Arrays& arrays, const ImageTable& table, int begin, int, PairBuffers&)
        : s(arrays), images(table), first(begin) {}

    // Numbers [k, k + 4) of the records of pairs c and c + 2.
    template <int k>
    HWY_INLINE V Joined(int c) const {
        const auto of = [&](const auto* index) HWY_ATTR {
            return Join(s.record + std::size_t{kRecord} * index[c] + k,
                        s.record + std::size_t{kRecord} * index[c + 2] + k);
        };
        const V pair = hn::MulAdd(Join(kSign + k, kSign + k), of(s.i), of(s.j));
        if constexpr (!kWrapped) return pair;
        return hn::Add(pair, Join(images.shift + std::size_t{kRecord} * s.image[c] + k,
                                  images.shift + std::size_t{kRecord} * s.image[c + 2] + k));
    }
    HWY_INLINE Lanes Load(int c) const {
        V geometry[4], rotation[4], p[4], q[4];
        for (int k = 0; k < 4; ++k) {
            const int pair = first + c + JoinedRow(k);
            geometry[k] = Joined<0>(pair), rotation[k] = Joined<4>(pair);
        }
        Columns(geometry, p), Columns(rotation, q);
        return {p[0], p[1], p[2], p[3], q[0], q[1], q[2], q[3]};
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

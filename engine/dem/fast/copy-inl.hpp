// Grains on their way between a packing at rest and the records of the kernel; included once per instruction
// set (no include guard by design).
#if defined(SANDGRAPH_FAST_COPY_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SANDGRAPH_FAST_COPY_INL
#undef SANDGRAPH_FAST_COPY_INL
#else
#define SANDGRAPH_FAST_COPY_INL
#endif

#include "dem/fast/motion-inl.hpp"
#include "dem/fast/packing.hpp"

HWY_BEFORE_NAMESPACE();
namespace sandgraph::dem::HWY_NAMESPACE {

using F = hn::Rebind<float, D>;

void UnpackGrains(const double* HWY_RESTRICT position, const float* HWY_RESTRICT velocity,
                  const double* HWY_RESTRICT radius, int grains, double* HWY_RESTRICT records) {
    const D d;
    const F f;
    const int lanes = static_cast<int>(hn::Lanes(d)), whole = grains / lanes * lanes;
    for (int g = 0; g < whole; g += lanes) {
        V x, y;
        hn::Vec<F> vx, vy, w;
        hn::LoadInterleaved2(d, position + 2 * g, x, y);
        hn::LoadInterleaved3(f, velocity + 3 * g, vx, vy, w);
        StoreGrains(x, y, hn::PromoteTo(d, vx), hn::PromoteTo(d, vy), hn::LoadU(d, radius + g),
                    hn::PromoteTo(d, w), records + kRecord * g);
    }
    for (int g = whole; g < grains; ++g) {
        const double* x = position + 2 * g;
        const float* v = velocity + 3 * g;
        set_grain(records + kRecord * g, x[0], x[1], v[0], v[1], radius[g], v[2]);
    }
}

void PackGrains(const double* HWY_RESTRICT records, int grains, double* HWY_RESTRICT position,
                float* HWY_RESTRICT velocity) {
    const D d;
    const F f;
    const int lanes = static_cast<int>(hn::Lanes(d)), whole = grains / lanes * lanes;
    for (int g = 0; g < whole; g += lanes) {
        V x, y, vx, vy, r, w;
        LoadGrains(records + kRecord * g, x, y, vx, vy, r, w);
        hn::StoreInterleaved2(x, y, d, position + 2 * g);
        hn::StoreInterleaved3(hn::DemoteTo(f, vx), hn::DemoteTo(f, vy), hn::DemoteTo(f, w), f,
                              velocity + 3 * g);
    }
    for (int g = whole; g < grains; ++g) {
        const double* a = records + kRecord * g;
        position[2 * g] = a[0], position[2 * g + 1] = a[1];
        velocity[3 * g] = float(a[2]), velocity[3 * g + 1] = float(a[3]), velocity[3 * g + 2] = float(a[6]);
    }
}

// `count` is a multiple of FastState::kLanes.
void Widen(const float* HWY_RESTRICT from, int count, double* HWY_RESTRICT to) {
    const D d;
    for (int k = 0; k < count; k += static_cast<int>(hn::Lanes(d)))
        hn::StoreU(hn::PromoteTo(d, hn::LoadU(F(), from + k)), d, to + k);
}
void Narrow(const double* HWY_RESTRICT from, int count, float* HWY_RESTRICT to) {
    const D d;
    for (int k = 0; k < count; k += static_cast<int>(hn::Lanes(d)))
        hn::StoreU(hn::DemoteTo(F(), hn::LoadU(d, from + k)), F(), to + k);
}

}  // namespace sandgraph::dem::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

// Features and network of the kernel; included once per instruction set (no include guard by design).
#if defined(SANDGRAPH_SURROGATE_NETWORK_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SANDGRAPH_SURROGATE_NETWORK_INL
#undef SANDGRAPH_SURROGATE_NETWORK_INL
#else
#define SANDGRAPH_SURROGATE_NETWORK_INL
#endif

#include "surrogate/check_model.hpp"
#include "surrogate/model.hpp"
#include "surrogate/vector_math-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sandgraph::surrogate::HWY_NAMESPACE {

// y = weight x + bias, four outputs at a time: the inputs stay in registers.
template <std::size_t kRows>
HWY_INLINE void DenseRows(const Layer& layer, std::size_t first, const V* HWY_RESTRICT x, V* HWY_RESTRICT y) {
    const double* HWY_RESTRICT row = layer.weight.data() + first * layer.inputs;
    V sum[kRows];
    for (std::size_t r = 0; r < kRows; ++r) sum[r] = Set(layer.bias[first + r]);
    for (std::size_t i = 0; i < layer.inputs; ++i)
        for (std::size_t r = 0; r < kRows; ++r)
            sum[r] = hn::MulAdd(Set(row[r * layer.inputs + i]), x[i], sum[r]);
    for (std::size_t r = 0; r < kRows; ++r) y[first + r] = sum[r];
}

HWY_INLINE void Dense(const Layer& layer, const V* HWY_RESTRICT x, V* HWY_RESTRICT y) {
    std::size_t o = 0;
    for (; o + 4 <= layer.outputs; o += 4) DenseRows<4>(layer, o, x, y);
    for (; o < layer.outputs; ++o) DenseRows<1>(layer, o, x, y);
}

// forward() of network.hpp for a vector of points. `x` is overwritten; the answer is in `y` [max_width].
HWY_INLINE void Forward(const std::vector<Layer>& layers, V* HWY_RESTRICT x, V* HWY_RESTRICT y) {
    for (std::size_t l = 0; l + 1 < layers.size(); ++l) {
        Dense(layers[l], x, y);
        for (std::size_t o = 0; o < layers[l].outputs; ++o) x[o] = Tanh(y[o]);
    }
    Dense(layers.back(), x, y);
}

}  // namespace sandgraph::surrogate::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

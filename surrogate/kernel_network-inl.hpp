// Features and network of the kernel; included once per instruction set (no include guard by design).
#if defined(SANDGRAPH_SURROGATE_NETWORK_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SANDGRAPH_SURROGATE_NETWORK_INL
#undef SANDGRAPH_SURROGATE_NETWORK_INL
#else
#define SANDGRAPH_SURROGATE_NETWORK_INL
#endif

#include "surrogate/kernel_model.hpp"
#include "surrogate/vector_math-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sandgraph::surrogate::HWY_NAMESPACE {

// kRows of y = weight x + bias; advances `weight`.
template <std::size_t kRows>
HWY_INLINE void DenseRows(const double* HWY_RESTRICT& weight, const double* HWY_RESTRICT bias,
                          std::size_t inputs, const V* HWY_RESTRICT x, V* HWY_RESTRICT y) {
    V sum[kRows];
    for (std::size_t r = 0; r < kRows; ++r) sum[r] = Set(bias[r]);
    for (std::size_t i = 0; i < inputs; ++i, weight += kRows)
        for (std::size_t r = 0; r < kRows; ++r) sum[r] = hn::MulAdd(Set(weight[r]), x[i], sum[r]);
    for (std::size_t r = 0; r < kRows; ++r) y[r] = sum[r];
}

HWY_INLINE void Dense(const PackedLayer& layer, const V* HWY_RESTRICT x, V* HWY_RESTRICT y) {
    constexpr std::size_t block = PackedLayer::block;
    const double *weight = layer.weight.data(), *bias = layer.bias.data();
    std::size_t o = 0;
    for (; o + block <= layer.outputs; o += block) DenseRows<block>(weight, bias + o, layer.inputs, x, y + o);
    for (; o < layer.outputs; ++o) DenseRows<1>(weight, bias + o, layer.inputs, x, y + o);
}

// forward() of network.hpp for a vector of points. `x` is overwritten; the answer is in `y` [max_width].
HWY_INLINE void Forward(const std::vector<PackedLayer>& layers, V* HWY_RESTRICT x, V* HWY_RESTRICT y) {
    for (std::size_t l = 0; l + 1 < layers.size(); ++l) {
        Dense(layers[l], x, y);
        for (std::size_t o = 0; o < layers[l].outputs; ++o) x[o] = Tanh(y[o]);
    }
    Dense(layers.back(), x, y);
}

}  // namespace sandgraph::surrogate::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

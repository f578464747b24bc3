#include "training/element_rollout.hpp"

#include <algorithm>
#include <cstring>

namespace sandgraph::training::fused {
namespace {

// Elements are loaded in proportion to their friction limits; limits that the start is above are raised.
template <class T>
State<T> loaded(const Weights<T>& w, const Range<T>& range, const Given<T>& given, State<T> s, bool net) {
    using V = Lanes<T>;
    Forward<T> f;
    f.run(w, range, given, s, net);
    V total = V::Zero();
    for (const V& r : f.strength) total += r;
    const V re = s.re[0], im = s.im[0], q = (re.square() + im.square()).sqrt();
    for (int k = 0; k < M; ++k) s.re[k] = re * f.strength[k] / total, s.im[k] = im * f.strength[k] / total;
    s.scale = (q / s.p / total).max(T(1));
    return s;
}

template <class T>
struct Window {
    std::int64_t first, count, histories;
    Lanes<T> load(const T* row, std::int64_t step) const {
        Lanes<T> out = Lanes<T>::Zero();
        std::copy_n(row + step * histories + first, count, out.data());
        return out;
    }
    void store(T* row, std::int64_t step, const Lanes<T>& v) const {
        std::copy_n(v.data(), count, row + step * histories + first);
    }
};

template <class T>
Window<T> window(const Blocks<T>& blocks, std::size_t block) {
    const auto first = static_cast<std::int64_t>(block) * lanes;
    return {first, std::min<std::int64_t>(lanes, blocks.histories - first), blocks.histories};
}

template <class T>
Lanes<T> sum(const std::array<Lanes<T>, M>& parts) {
    Lanes<T> out = parts[0];
    for (int k = 1; k < M; ++k) out += parts[k];
    return out;
}

// Weights hold nothing but numbers, so that they can be walked through as one row.
template <class T>
Weights<T> summed_over_lanes(const Weights<Lanes<T>>& gradient) {
    constexpr std::size_t count = sizeof(Weights<T>) / sizeof(T);
    static_assert(sizeof(Weights<Lanes<T>>) == count * sizeof(Lanes<T>));
    Weights<T> out;
    const auto* from = reinterpret_cast<const T*>(&gradient);
    auto* to = reinterpret_cast<T*>(&out);
    for (std::size_t k = 0; k < count; ++k) {
        to[k] = 0;
        for (int lane = 0; lane < lanes; ++lane) to[k] += from[k * lanes + static_cast<std::size_t>(lane)];
    }
    return out;
}

}  // namespace

template <class T>
void roll_out(const Weights<T>& w, const Range<T>& range, const Blocks<T>& blocks, std::size_t block,
              bool net, const Answers<T>& answers, std::vector<State<T>>* tape) {
    const Window<T> to = window(blocks, block);
    State<T> s = loaded(w, range, blocks.given[block].front(), blocks.start[block], net);
    Forward<T> f;
    for (std::int64_t step = 0; step < blocks.steps; ++step) {
        if (tape) (*tape)[static_cast<std::size_t>(step)] = s;
        f.run(w, range, blocks.given[block][static_cast<std::size_t>(step)], s, net);
        s = f.next(w, s);
        to.store(answers.p, step, s.p);
        to.store(answers.re, step, sum<T>(s.re));
        to.store(answers.im, step, sum<T>(s.im));
        to.store(answers.slip, step, s.gamma);
        lead(blocks.given[block][static_cast<std::size_t>(step)], s);
    }
}

template <class T>
Weights<T> roll_back(const Weights<T>& w, const Range<T>& range, const Blocks<T>& blocks, std::size_t block,
                     bool net, const Answers<const T>& adjoint, const std::vector<State<T>>& tape) {
    using V = Lanes<T>;
    const Window<T> from = window(blocks, block);
    Weights<V> gradient;
    std::memset(static_cast<void*>(&gradient), 0, sizeof(gradient));
    State<T> a{V::Zero(), V::Zero(), {}, {}, V::Zero()};
    for (int k = 0; k < M; ++k) a.re[k] = a.im[k] = V::Zero();
    Forward<T> f;
    for (std::int64_t step = blocks.steps - 1; step >= 0; --step) {
        const V re = from.load(adjoint.re, step), im = from.load(adjoint.im, step);
        const Given<T>& g = blocks.given[block][static_cast<std::size_t>(step)];
        const State<T>& s = tape[static_cast<std::size_t>(step)];
        f.run(w, range, g, s, net);
        lead_back(g, f.p, a);
        a.p += from.load(adjoint.p, step);
        for (int k = 0; k < M; ++k) a.re[k] += re, a.im[k] += im;
        step_back(w, g, s, f, net, a, gradient);
    }
    return summed_over_lanes(gradient);
}

template void roll_out(const Weights<float>&, const Range<float>&, const Blocks<float>&, std::size_t, bool,
                       const Answers<float>&, std::vector<State<float>>*);
template void roll_out(const Weights<double>&, const Range<double>&, const Blocks<double>&, std::size_t, bool,
                       const Answers<double>&, std::vector<State<double>>*);
template Weights<float> roll_back(const Weights<float>&, const Range<float>&, const Blocks<float>&,
                                  std::size_t, bool, const Answers<const float>&,
                                  const std::vector<State<float>>&);
template Weights<double> roll_back(const Weights<double>&, const Range<double>&, const Blocks<double>&,
                                   std::size_t, bool, const Answers<const double>&,
                                   const std::vector<State<double>>&);

}  // namespace sandgraph::training::fused

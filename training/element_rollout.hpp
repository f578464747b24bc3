#pragma once
#include <cstdint>
#include <vector>

#include "training/element_step.hpp"

namespace sandgraph::training::fused {

// A batch as plain arrays, in blocks of `lanes` histories: [block x step] and [block].
template <class T>
struct Blocks {
    std::int64_t steps = 0, histories = 0;
    std::vector<std::vector<Given<T>>> given;  // [block][step]
    std::vector<State<T>> start;               // [block] p, gamma and, in re[0], im[0], the deviator
};

// Answers of one member, or their adjoint: [step x history] each.
template <class T>
struct Answers {
    T *p, *re, *im, *slip;  // slip: not in the adjoint
};

// Rolls one block out; with `tape` [steps] keeps the state before every step.
template <class T>
void roll_out(const Weights<T>& w, const Range<T>& range, const Blocks<T>& blocks, std::size_t block,
              bool net, const Answers<T>& answers, std::vector<State<T>>* tape);

// Gradient of the weights for the answers' adjoint, from the tape of roll_out.
template <class T>
Weights<T> roll_back(const Weights<T>& w, const Range<T>& range, const Blocks<T>& blocks, std::size_t block,
                     bool net, const Answers<const T>& adjoint, const std::vector<State<T>>& tape);

}  // namespace sandgraph::training::fused

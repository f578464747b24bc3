#pragma once
#include <span>
#include <vector>

#include "surrogate/model.hpp"

namespace sandgraph::surrogate {

// Output of the layers for the input x: tanh after each but the last.
std::vector<double> forward(std::span<const Layer> layers, std::span<const double> x);

}  // namespace sandgraph::surrogate

#pragma once
#include <optional>

#include "dem/packing/observables.hpp"
#include "graph/pull.hpp"

namespace sandgraph::simulation {

// Porosity of a point under any law; a closed-form law starts from `initial_porosity`.
double point_porosity(const graph::Pull& pull, std::size_t point, double initial_porosity);

// What the point's packing shows; none where no packing answers for it (closed-form laws, surrogates).
std::optional<dem::Observables> point_packing(const graph::Pull& pull, std::size_t point);

}  // namespace sandgraph::simulation

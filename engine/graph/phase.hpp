#pragma once
#include <functional>
#include <string>
#include <vector>

#include "stress/stage.hpp"

namespace sandgraph::graph {

using stress::Data, stress::Version, stress::settled;

// One phase of a step. The order of the phases is data: whoever reads a version waits for its writer, and
// whoever writes the next one waits for its readers. Listing the phases in another order changes nothing.
struct Phase {
    std::string name;
    std::vector<Version> reads, writes;
    std::function<void()> run;
};

// For each phase the phases that it must wait for, in rising order. Throws std::logic_error on a version with
// two writers or none, or when phases wait for each other.
std::vector<std::vector<std::size_t>> predecessors(const std::vector<Phase>& phases);

// An order to run the phases in one after the other: the first that is ready, in the order of the list.
std::vector<std::size_t> serial_order(const std::vector<std::vector<std::size_t>>& before);

}  // namespace sandgraph::graph

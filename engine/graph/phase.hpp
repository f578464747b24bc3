#pragma once
#include <functional>
#include <string>
#include <vector>

namespace sandgraph::graph {

// One stage of a step. The order of the stages is data: a resource is written by one phase a step, and
// whoever reads it comes after. Listing the phases in another order changes nothing.
struct Phase {
    std::string name;
    std::vector<std::string> reads;  // resources of this step (what no phase writes is from the step before)
    std::vector<std::string> writes;
    std::function<void()> run;
};

// For each phase the phases it must wait for. Throws std::logic_error on two writers of a resource or a
// circle.
std::vector<std::vector<std::size_t>> predecessors(const std::vector<Phase>& phases);

}  // namespace sandgraph::graph

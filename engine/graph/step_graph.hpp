#pragma once
#include <memory>
#include <string>
#include <vector>

#include "graph/phase.hpp"

namespace sandgraph::graph {

struct PhaseTime {
    std::string name;
    double seconds = 0;  // wall time, cumulated over all steps
};

// The phases of a step as a oneTBB flow graph, built once and run every step. An exception of a phase ends
// the step and is thrown on by run().
class StepGraph {
  public:
    explicit StepGraph(std::vector<Phase> phases);
    ~StepGraph();
    StepGraph(const StepGraph&) = delete;
    StepGraph& operator=(const StepGraph&) = delete;

    void run();
    const std::vector<PhaseTime>& times() const;
    const std::vector<Phase>& phases() const;

  private:
    struct Nodes;
    std::unique_ptr<Nodes> nodes_;
};

}  // namespace sandgraph::graph

#pragma once
#include <stdexcept>

#include "graph/step_graph.hpp"
#include "graph/step_phases.hpp"
#include "stress/elastic.hpp"

namespace sandgraph::support {

// Whole steps over points that a test has made: their stress hardly changes, for the law is next to limp.
class RandomStep {
  public:
    RandomStep(const graph::StepSettings& settings, mpm::Points points, const mpm::GridShape& grid)
        : state_(settings, std::move(points), grid) {
        state_.law =
            std::make_unique<stress::Elastic>(stress::ElasticConstants{1, 0.3}, state_.points.stress);
        state_.law->initialise(state_.batch());
    }
    graph::GroundState& state() { return state_; }
    void steps(int count) {
        graph::StepGraph graph(graph::step_phases(state_));
        for (int k = 0; k < count; ++k) {
            graph.run();
            if (!state_.status.good()) throw std::runtime_error("a point left the grid");
        }
    }

  private:
    graph::GroundState state_;
};

}  // namespace sandgraph::support

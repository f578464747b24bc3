#pragma once
#include "graph/ground_state.hpp"
#include "graph/step_graph.hpp"

namespace sandgraph::graph {

// How the plate is pulled: at rest while the ground settles, then a smooth ramp to a constant rate.
struct PullPlan {
    Vec2 direction = Vec2(0, 1);
    double width = 1;      // B [m]
    double rate = 0.05;    // [m/s]
    double ramp = 0.01;    // share of B over which the rate rises
    double settle = 0.05;  // [s] at rest before the pull
};

// Rate of the plate at time t since the start [m/s]: a smoothstep over the ramp, continuous in acceleration.
double pull_rate(const PullPlan& plan, double time);

// The running simulation: state, its step graph, and time.
class Pull {
  public:
    Pull(std::unique_ptr<GroundState> state, const PullPlan& plan);

    void step();  // one MPM step; throws std::runtime_error when a point left the grid
    double time() const { return time_; }
    std::int64_t steps() const { return steps_; }
    double d_over_B() const { return travelled_ / plan_.width; }
    // Force of the soil on the plate against the pull, of the last step [N/m], for the modelled part.
    double load() const;
    // Its shares on the face that leads and on the one that trails [N/m].
    double leading() const;
    double trailing() const;

    GroundState& state() { return *state_; }
    const GroundState& state() const { return *state_; }
    const StepGraph& graph() const { return graph_; }
    const PullPlan& plan() const { return plan_; }
    void archive(Archive& a);

  private:
    mpm::Face leading_face() const;
    std::unique_ptr<GroundState> state_;
    PullPlan plan_;
    StepGraph graph_;
    double time_ = 0, travelled_ = 0;
    std::int64_t steps_ = 0;
};

}  // namespace sandgraph::graph

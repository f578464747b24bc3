#pragma once
#include "graph/ground_state.hpp"
#include "graph/step_graph.hpp"
#include "simulation/spec.hpp"

namespace sandgraph::simulation {

// The running simulation: the state of the ground and its bodies, the step graph over it, and the clock.
class Simulation {
  public:
    // At rest before the first step. std::logic_error for more bodies than one (so far).
    explicit Simulation(const Spec& spec);

    // One MPM step, the bodies driven by their programmes. std::runtime_error when a point left the grid.
    void step();
    // The same with the first body at `velocity` [m/s], whatever its programme says.
    void step(const Vec2& velocity);

    double time() const { return time_; }  // [s]
    std::int64_t steps() const { return steps_; }
    bool anchored() const { return loaded_ && !programmes_.empty(); }
    // Of a body along its programme's direction [m].
    double travel(std::size_t body = 0) const { return travel_[body]; }
    // The anchor's travel in its widths; 0 in ground without one.
    double d_over_B() const { return anchored() ? travel_.front() / width_ : 0; }
    // What marks of outputs count in: d/B, in ground without an anchor time [s].
    double mark() const { return anchored() ? d_over_B() : time_; }
    double next_mark() const;  // after the next step, at most

    // Of the anchor, for the modelled part: force of the soil against its direction in the last step [N/m].
    double load() const;
    // Its shares on the face that leads and on the one that trails [N/m].
    double leading() const;
    double trailing() const;

    graph::GroundState& state() { return *state_; }
    const graph::GroundState& state() const { return *state_; }
    const graph::StepGraph& graph() const { return graph_; }
    void archive(Archive& a);

  private:
    void drive();
    void advance();
    const mpm::Reaction& reaction() const;
    double resistance(const Vec2& force) const;
    mpm::Face leading_face() const;
    std::unique_ptr<graph::GroundState> state_;
    graph::StepGraph graph_;
    std::vector<Programme> programmes_;  // by body
    std::vector<double> travel_;         // by body [m]
    double width_, time_ = 0;
    bool loaded_;
    std::int64_t steps_ = 0;
};

}  // namespace sandgraph::simulation

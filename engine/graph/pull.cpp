#include "graph/pull.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "graph/step_phases.hpp"

namespace sandgraph::graph {

double pull_rate(const PullPlan& plan, double time) {
    const double since = time - plan.settle;
    if (since <= 0) return 0;
    const double duration = 2 * plan.ramp * plan.width / plan.rate;  // mean rate of a smoothstep is one half
    const double s = duration > 0 ? std::min(1.0, since / duration) : 1.0;
    return plan.rate * s * s * (3 - 2 * s);
}

Pull::Pull(std::unique_ptr<GroundState> state, const PullPlan& plan)
    : state_(std::move(state)), plan_(plan), graph_(step_phases(*state_)) {}

void Pull::step() {
    const double dt = state_->settings.dt, rate = pull_rate(plan_, time_ + 0.5 * dt);
    state_->plate.velocity = rate * plan_.direction;
    state_->d_over_B = d_over_B();
    graph_.run();
    time_ += dt;
    travelled_ += dt * rate;
    ++steps_;
    if (!state_->status.good())
        throw std::runtime_error("material point " + std::to_string(state_->status.first) +
                                 " left the grid: the ground moved further than the domain allows");
}

double Pull::load() const { return -state_->contact.reaction.total().dot(plan_.direction); }

mpm::Face Pull::leading_face() const { return plan_.direction.y() > 0 ? mpm::Face::top : mpm::Face::right; }

double Pull::leading() const { return -state_->contact.reaction.face(leading_face()).dot(plan_.direction); }

double Pull::trailing() const {
    const mpm::Face face = leading_face() == mpm::Face::top ? mpm::Face::bottom : mpm::Face::left;
    return -state_->contact.reaction.face(face).dot(plan_.direction);
}

void Pull::archive(Archive& a) {
    std::vector<double> clock = {time_, travelled_};
    std::vector<std::int64_t> count = {steps_};
    field_of_known_length(a, "clock", clock);
    field_of_known_length(a, "steps", count);
    time_ = clock[0], travelled_ = clock[1], steps_ = count[0];
    state_->archive(a);
}

}  // namespace sandgraph::graph

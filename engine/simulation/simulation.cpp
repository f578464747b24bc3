#include "simulation/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "base/contracts.hpp"
#include "graph/access_check.hpp"
#include "graph/step_phases.hpp"
#include "mpm/layout.hpp"
#include "mpm/time_step.hpp"

namespace sandgraph::simulation {
namespace {

constexpr std::int64_t kCheckedSteps = 3;

mpm::Points lay_out(const Spec& spec) {
    SG_EXPECT(spec.grid.cell > 0 && spec.ground.density > 0 && spec.law);
    const GroundSpec& g = spec.ground;
    mpm::Layout layout{g.extent,   spec.grid.cell, g.points_per_cell, g.density,
                       g.cavities, g.inside,       g.columns_on_sides};
    for (const BodySpec& body : spec.bodies)
        if (!body.plate.round) layout.cavities.push_back(body.plate.rectangle());
    layout.inside = [&](double x, double y) {
        const auto on = [&](const BodySpec& b) { return b.plate.round && b.plate.distance(x, y) < 0; };
        return !std::ranges::any_of(spec.bodies, on) && (!g.inside || g.inside(x, y));
    };
    mpm::Points points = mpm::lay_out(layout);
    for (std::size_t p = 0; g.velocity && p < points.size(); ++p) {
        const Vec2 v = g.velocity(points.x[p], points.y[p]);
        points.vx[p] = v.x(), points.vy[p] = v.y();
    }
    return points;
}

graph::StepSettings settings_of(const Spec& spec, double modulus) {
    mpm::Scheme scheme = spec.scheme;
    if (spec.bodies.empty()) scheme.contact_stiffness = 0;
    const mpm::Medium medium{spec.grid.cell, modulus, spec.ground.density};
    graph::StepSettings s;
    s.dt = spec.stable ? mpm::time_step(scheme, medium) : scheme.courant * mpm::crossing_time(scheme, medium);
    s.scheme = spec.scheme;
    s.scheme.pic_fraction = mpm::pic_share(scheme, medium, s.dt);
    s.gravity = spec.gravity;
    s.surcharge = spec.surcharge;
    s.boundaries = spec.boundaries;
    return s;
}

std::unique_ptr<graph::GroundState> state_of(const Spec& spec) {
    mpm::Points points = lay_out(spec);
    auto law = spec.law(points);
    const double modulus = law->p_wave_modulus();
    auto state =
        std::make_unique<graph::GroundState>(settings_of(spec, modulus), std::move(points), spec.grid);
    state->law = std::move(law);
    state->bands = mpm::BandStress(spec.internal_length, modulus, state->points, spec.grid.cell);
    state->law->initialise(state->batch());
    for (const BodySpec& body : spec.bodies) {
        mpm::RigidPlate plate = body.plate;
        plate.stiffness = mpm::contact_stiffness(spec.scheme.contact_stiffness, modulus, spec.grid.cell);
        state->add_body(plate);
    }
    return state;
}

mpm::Face leading_face_of(const Vec2& direction) {
    if (std::fabs(direction.y()) >= std::fabs(direction.x()))
        return direction.y() > 0 ? mpm::Face::top : mpm::Face::bottom;
    return direction.x() > 0 ? mpm::Face::right : mpm::Face::left;
}

}  // namespace

Simulation::Simulation(const Spec& spec)
    : state_(state_of(spec)), graph_(graph::step_phases(*state_)), width_(spec.width), loaded_(spec.loaded) {
    for (const BodySpec& body : spec.bodies) programmes_.push_back(body.programme);
    travel_.assign(programmes_.size(), 0.0);
}

void Simulation::drive() {
    const double middle = time_ + 0.5 * state_->settings.dt;
    for (std::size_t k = 0; k < programmes_.size(); ++k)
        state_->bodies[k].plate.velocity = rate_at(programmes_[k], middle) * programmes_[k].direction;
}

void Simulation::step() {
    drive();
    advance();
}

void Simulation::step(const Vec2& velocity) {
    drive();
    if (!state_->bodies.empty()) state_->bodies.front().plate.velocity = velocity;
    advance();
}

void Simulation::advance() {
    const double dt = state_->settings.dt;
    SG_EXPECT(state_->bodies.size() == programmes_.size() && state_->settings.dt > 0);
    state_->d_over_B = d_over_B();
    // Development builds hold what the phases say against what they touch.
    if (SANDGRAPH_CONTRACTS && steps_ < kCheckedSteps)
        graph::run_checked(graph_.phases(), *state_);
    else
        graph_.run();
    time_ += dt;
    for (std::size_t k = 0; k < programmes_.size(); ++k)
        travel_[k] += dt * state_->bodies[k].plate.velocity.dot(programmes_[k].direction);
    ++steps_;
    if (!state_->status.good())
        throw std::runtime_error("material point " + std::to_string(state_->status.first) +
                                 " left the grid: the ground moved further than the domain allows");
}

double Simulation::resistance(const Vec2& force) const { return -force.dot(programmes_.front().direction); }

double Simulation::next_mark() const {
    const double dt = state_->settings.dt;
    return anchored() ? d_over_B() + dt * programmes_.front().rate / width_ : time_ + dt;
}

const mpm::Reaction& Simulation::reaction() const { return state_->bodies.front().contact.reaction; }

double Simulation::load() const { return resistance(reaction().total()); }
double Simulation::leading() const { return resistance(reaction().face(leading_face())); }
double Simulation::trailing() const {
    if (state_->bodies.front().plate.round) return 0;
    return resistance(reaction().face(leading_face_of(-programmes_.front().direction)));
}

mpm::Face Simulation::leading_face() const {
    if (state_->bodies.front().plate.round) return mpm::Face::round;
    return leading_face_of(programmes_.front().direction);
}

void Simulation::archive(Archive& a) {
    std::vector<double> clock = {time_};
    clock.insert(clock.end(), travel_.begin(), travel_.end());
    std::vector<std::int64_t> count = {steps_};
    field_of_known_length(a, "clock", clock);
    field_of_known_length(a, "steps", count);
    time_ = clock[0], steps_ = count[0];
    std::copy(clock.begin() + 1, clock.end(), travel_.begin());
    state_->archive(a);
}

}  // namespace sandgraph::simulation

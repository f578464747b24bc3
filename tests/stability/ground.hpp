#pragma once
#include <functional>
#include <memory>
#include <optional>

#include "graph/ground_state.hpp"
#include "graph/rve_law.hpp"
#include "graph/screening/law.hpp"
#include "graph/step_graph.hpp"
#include "stress/mohr_coulomb.hpp"

namespace sandgraph::stability {

inline constexpr double gravity = 9.81;  // [m/s2]

// Ground of packings, with or without a plate; what a case says of it.
struct GroundSpec {
    mpm::Rectangle soil{0, 0, 1, 1};  // [m]
    double cell = 0.1;                // [m]
    int per_cell = 1;
    double room = 0.5;  // of the grid above the soil [m]
    double wide = 0;    // of the grid right of the soil [m]
    int grains = 400;   // of a packing
    mpm::Boundaries boundaries{mpm::Side::mirror, mpm::Side::mirror, mpm::Side::fixed, mpm::Side::free};
    double courant = 0.3, damping = 0.05, surcharge = 0;
    std::optional<mpm::Rectangle> plate;                  // a rough one; x = 0 may be its symmetry plane
    std::optional<stress::MohrCoulombConstants> plastic;  // what the ground is made of instead of packings
    // In-situ pressure [Pa] at a depth [m]; empty: surcharge and weight, K0 = 1.
    std::function<double(double)> pressure;
    std::function<void(dem::RveOptions&)> stepping;
    // Makes it a screening run: told the setup with the shipped surrogate and default gate.
    std::function<void(graph::ScreeningSetup&)> screening;
};

class Ground {
  public:
    explicit Ground(const GroundSpec& spec);

    // One step with the plate at this velocity. std::runtime_error when a point left the grid.
    void step(const Vec2& plate_velocity = Vec2::Zero());
    graph::GroundState& state() { return *state_; }
    mpm::Points& points() { return state_->points; }
    const mpm::Points& points() const { return state_->points; }
    const graph::RveLaw& rves() const { return dynamic_cast<const graph::RveLaw&>(*state_->law); }
    const graph::ScreeningLaw& screening() const {
        return dynamic_cast<const graph::ScreeningLaw&>(*state_->law);
    }
    double dt() const { return state_->settings.dt; }
    double cell() const { return state_->grid.shape.cell; }
    double time() const { return time_; }
    double density() const { return density_; }                                // [kg/m3]
    double travelled() const { return travelled_; }                            // of the plate, up [m]
    double load() const { return state_->contact.reaction.total().y() * -1; }  // against an upward pull [N/m]
    double kinetic() const;                                                    // [J/m]
    double potential() const;                                                  // of gravity [J/m]
    double plate_work() const { return plate_work_; }                          // done on the soil [J/m]
    const graph::RveCounters& counters() const;

  private:
    std::unique_ptr<graph::GroundState> state_;
    std::unique_ptr<graph::StepGraph> graph_;
    double density_ = 0, time_ = 0, travelled_ = 0, plate_work_ = 0;
};

// Largest difference of a point's stress from `before`, in shares of max(p before, 1 kPa).
double stress_drift(const mpm::Points& points, const std::vector<Stress>& before);

}  // namespace sandgraph::stability

#pragma once
#include <functional>
#include <memory>
#include <optional>

#include "graph/rve_law.hpp"
#include "graph/screening/law.hpp"
#include "simulation/simulation.hpp"
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
    graph::GroundState& state() { return simulation_->state(); }
    mpm::Points& points() { return state().points; }
    const mpm::Points& points() const { return simulation_->state().points; }
    const graph::Body& body() const { return simulation_->state().bodies.front(); }
    const graph::RveLaw& rves() const {
        return dynamic_cast<const graph::RveLaw&>(*simulation_->state().law);
    }
    const graph::ScreeningLaw& screening() const {
        return dynamic_cast<const graph::ScreeningLaw&>(*simulation_->state().law);
    }
    double dt() const { return simulation_->state().settings.dt; }
    double cell() const { return simulation_->state().grid.shape.cell; }
    double time() const { return simulation_->time(); }
    double density() const { return density_; }                 // [kg/m3]
    double travelled() const { return simulation_->travel(); }  // of the plate, up [m]
    double load() const { return simulation_->load(); }         // against an upward pull [N/m]
    double kinetic() const;                                     // [J/m]
    double potential() const;                                   // of gravity [J/m]
    double plate_work() const { return plate_work_; }           // done on the soil [J/m]
    const graph::RveCounters& counters() const;

  private:
    bool has_plate() const { return simulation_->anchored(); }
    std::unique_ptr<simulation::Simulation> simulation_;
    double density_ = 0, plate_work_ = 0;
};

// Largest difference of a point's stress from `before`, in shares of max(p before, 1 kPa).
double stress_drift(const mpm::Points& points, const std::vector<Stress>& before);

}  // namespace sandgraph::stability

#pragma once
#include <memory>
#include <numeric>

#include "mpm/band_stress.hpp"
#include "mpm/boundary.hpp"
#include "mpm/cell_mean.hpp"
#include "mpm/contact.hpp"
#include "mpm/grid.hpp"
#include "mpm/node_work.hpp"
#include "mpm/order.hpp"
#include "mpm/plate.hpp"
#include "mpm/points.hpp"
#include "mpm/time_step.hpp"
#include "mpm/transfer.hpp"
#include "stress/law.hpp"

namespace sandgraph::graph {

// What stays the same from step to step.
struct StepSettings {
    double dt = 0;                // [s]
    mpm::Scheme scheme;           // pic_fraction: that of a step of dt
    Vec2 gravity = Vec2::Zero();  // [m/s2]
    double surcharge = 0;         // [Pa]
    mpm::Boundaries boundaries;
};

// A rigid body in the ground and what it feels of it.
struct Body {
    mpm::RigidPlate plate;
    mpm::Contact contact;
};

// Everything that changes from step to step: the typed state that the phases work on.
struct GroundState {
    GroundState(StepSettings step_settings, mpm::Points ground, const mpm::GridShape& shape);

    StepSettings settings;
    mpm::Points points;
    mpm::Grid grid;
    mpm::Order order;
    std::vector<Body> bodies;
    std::unique_ptr<stress::Law> law;
    std::vector<std::int32_t> all_points;  // 0 .. N-1, the law's batch
    double light = 0;       // a lighter node follows its neighbours [kg/m] (mpm/light_nodes.hpp)
    mpm::BandStress bands;  // where bands have a width of their own
    mpm::CellMean means;    // reduced integration, where a cell holds several points
    mpm::Status status;
    double d_over_B = 0;      // of the anchor before this step, for the law's records; 0 without one
    double stress_work = 0;   // accumulated sum of V sigma : d(eps), mid-step [J/m]
    mpm::NodeWork node_work;  // accumulated, where there is a body [J/m]
    double work_before = 0;   // this step's half, with the old stress

    void add_body(const mpm::RigidPlate& plate);
    stress::Batch batch() {
        return {all_points,
                points.F_inc,
                points.stress,
                settings.dt,
                {points.x, points.y, points.volume, grid.shape.cell, d_over_B}};
    }
    void archive(Archive& a);
};

}  // namespace sandgraph::graph

#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "mpm/boundary.hpp"
#include "mpm/grid.hpp"
#include "mpm/plate.hpp"
#include "mpm/points.hpp"
#include "mpm/time_step.hpp"
#include "simulation/programme.hpp"
#include "stress/law.hpp"

namespace sandgraph::simulation {

// The ground before the first step: a rectangle of material points.
struct GroundSpec {
    mpm::Rectangle extent{0, 0, 1, 1};  // whole numbers of point spacings wide and high [m]
    int points_per_cell = 1;            // 1, 4 or 9
    double density = 2000;              // in situ, rho_grain (1 - n) [kg/m3]
    // Where there is no ground, beside the bodies [m].
    std::vector<mpm::Rectangle> cavities;
    bool columns_on_sides = false;  // of points, where the sides are mirror planes (mpm/layout.hpp)
    // Whether there is ground about a point of the rectangle; empty: everywhere.
    std::function<bool(double x, double y)> inside;
    // Velocity before the first step [m/s]; empty: at rest.
    std::function<Vec2(double x, double y)> velocity;
};

// A rigid body of prescribed motion. `plate`: its place, size and friction, and the rest pressure on it;
// velocity and stiffness are the simulation's. No ground is laid where it stands.
struct BodySpec {
    mpm::RigidPlate plate;
    Programme programme;
};

using LawFactory = std::function<std::unique_ptr<stress::Law>(const mpm::Points&)>;

// All that a simulation is made of, from a scene (spec_of) or from C++.
struct Spec {
    GroundSpec ground;
    mpm::GridShape grid;
    mpm::Boundaries boundaries{mpm::Side::mirror, mpm::Side::mirror, mpm::Side::fixed, mpm::Side::free};
    Vec2 gravity = Vec2(0, -9.81);  // [m/s2]
    double surcharge = 0;           // on the free surface [Pa]
    double internal_length = 0;     // of shear bands [m]; 0: the cell decides
    mpm::Scheme scheme;
    bool stable = true;            // false: courant may pass the stability limit, as a test of it wants
    std::vector<BodySpec> bodies;  // the first is the anchor, if there is one
    bool loaded = true;            // whether the load of the first body is what the run is about
    double width = 1;              // B [m]: d/B is the first body's travel over it
    LawFactory law;                // in-situ stress included
};

}  // namespace sandgraph::simulation

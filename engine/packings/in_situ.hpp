#pragma once
#include <memory>
#include <vector>

#include "dem/prepare/prepare.hpp"
#include "graph/rve_law.hpp"
#include "packings/sand_friction.hpp"
#include "scene/scene.hpp"
#include "stress/surrogate.hpp"

namespace sandgraph::packings {

// The ground of a scene before anything moves.
struct PreparedGround {
    double density = 0;  // in situ, rho_grain (1 - n) [kg/m3]
    // Peak, mean of the base packings in use (or that of the closed-form law) [rad].
    double friction_angle = 0;
    FrictionSample friction;           // of the sand: what formulas are compared with
    std::vector<double> row_pressure;  // in-situ vertical stress of each depth row's centre [Pa]
    // Of each depth row one of every base packing, in the order that deal() counts in (samples.hpp); empty
    // for closed-form laws.
    std::vector<graph::RowPacking> packings;
    std::shared_ptr<const stress::Surrogate> surrogate;  // of a screening run, else null
    std::vector<stress::PackingTraits> traits;           // of each of `packings`

    // Of the grains of all base packings [m].
    std::vector<double> radii() const;
};

// Prepares (or takes from the cache) the packings of every depth row at its in-situ stress, and measures the
// friction angle (friction.hpp).
PreparedGround prepare_ground(const scene::Scene& scene, const ProgressCallback& progress = {});

}  // namespace sandgraph::packings

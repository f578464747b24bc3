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
    double density = 0;         // in situ, rho_grain (1 - n) [kg/m3]
    double friction_angle = 0;  // peak, measured on the packing in use (or that of the closed-form law) [rad]
    FrictionSample friction;    // of the sand: what formulas are compared with
    std::vector<double> row_pressure;     // in-situ mean stress of each depth row's centre, K0 = 1 [Pa]
    std::vector<graph::RowPacking> rows;  // one packing a depth row; empty for closed-form laws
    std::shared_ptr<const stress::Surrogate> surrogate;  // of a screening run, else null
    std::vector<stress::PackingTraits> traits;           // of each row's packing; empty for closed-form laws
};

// Prepares (or takes from the cache) one packing per depth row at its in-situ stress, and measures the
// friction angle (friction.hpp).
PreparedGround prepare_ground(const scene::Scene& scene, const ProgressCallback& progress = {});

}  // namespace sandgraph::packings

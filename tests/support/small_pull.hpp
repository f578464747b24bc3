#pragma once
#include "dem/prepare/prepare.hpp"
#include "graph/rve_law.hpp"
#include "simulation/simulation.hpp"

namespace sandgraph::support {

// A pull that takes a second: 8 x 8 cells of 0.25 m, a packing of 100 grains at every point, plate 1 m deep.
std::unique_ptr<simulation::Simulation> small_pull();
// With all rules of visits on that are off by default.
std::unique_ptr<simulation::Simulation> small_carrying_pull();

// The same with a closed-form surrogate, a gate that some points pass, and every fourth point audited.
std::unique_ptr<simulation::Simulation> small_screening_pull();

// The three with packings that live elsewhere.
enum class SmallPull { full, carrying, screening };
std::unique_ptr<simulation::Simulation> small_pull_in(SmallPull kind, const graph::PoolMaker& make_pool);

// A ground of 32 x 64 cells round the same plate: more points than mpm::serial_limit, in nine bands.
std::unique_ptr<simulation::Simulation> wide_pull();

// Every bit that the simulation carries, as one text.
std::string digest(const simulation::Simulation& pull);

}  // namespace sandgraph::support

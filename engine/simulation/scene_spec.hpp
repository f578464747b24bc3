#pragma once
#include "packings/in_situ.hpp"
#include "simulation/simulation.hpp"

namespace sandgraph::simulation {

// What a checked scene asks for, on prepared ground.
Spec spec_of(const scene::Scene& scene, const packings::PreparedGround& ground,
             const graph::PoolMaker& make_pool = graph::local_pool);
// The same built, at rest before the first step. InputError for a plate too fast for the contact.
std::unique_ptr<Simulation> simulation_of(const scene::Scene& scene, const packings::PreparedGround& ground,
                                          const graph::PoolMaker& make_pool = graph::local_pool);

// Where the run ends: d/B of the anchor, in ground without one time [s].
double end_mark(const scene::Scene& scene);

// H [m], and with a surcharge q_s the embedment H + q_s/gamma [m] that has the same overburden.
double embedment(const scene::Anchor& anchor);
double equivalent_embedment(const scene::Scene& scene, const packings::PreparedGround& ground);
// B (gamma H + q_s) [N/m], the load that N_gamma counts in.
double unit_load(const scene::Scene& scene, const packings::PreparedGround& ground);

// Loads of a half model are doubled here and nowhere else.
double whole_plate_factor(const scene::Scene& scene);

}  // namespace sandgraph::simulation

#pragma once
#include <memory>

#include "graph/pull.hpp"
#include "packings/in_situ.hpp"
#include "scene/scene.hpp"

namespace sandgraph::simulation {

// The simulation of a checked scene on prepared ground, at rest before the first step.
std::unique_ptr<graph::Pull> build_pull(const scene::Scene& scene, const packings::PreparedGround& ground);

// H [m], and with a surcharge q_s the embedment H + q_s/gamma [m] that has the same overburden.
double embedment(const scene::Anchor& anchor);
double equivalent_embedment(const scene::Scene& scene, const packings::PreparedGround& ground);
// B (gamma H + q_s) [N/m], the load that N_gamma counts in.
double unit_load(const scene::Scene& scene, const packings::PreparedGround& ground);

// Loads of a half model are doubled here and nowhere else.
double whole_plate_factor(const scene::Scene& scene);

}  // namespace sandgraph::simulation

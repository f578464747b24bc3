#pragma once
#include "io/summary.hpp"
#include "simulation/run_session.hpp"

namespace sandgraph::results {

io::Summary summarise(const simulation::RunSession& session, const scene::Scene& scene,
                      const packings::PreparedGround& ground, int threads);

// What a user wants to read when a run has ended, a few lines.
std::string summary_text(const io::Summary& summary, const scene::Scene& scene);

}  // namespace sandgraph::results

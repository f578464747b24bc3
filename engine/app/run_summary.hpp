#pragma once
#include "app/run_session.hpp"
#include "io/summary.hpp"

namespace sandgraph::app {

// Has the load-displacement curve broken out, or does it still rise at its end?
bool broke_out(const io::Summary& summary);

io::Summary summarise(const RunSession& session, const scene::Scene& scene, const PreparedGround& ground,
                      int threads);

// What a user wants to read when a run has ended, a few lines.
std::string summary_text(const io::Summary& summary, const scene::Scene& scene, const PreparedGround& ground);

}  // namespace sandgraph::app

#pragma once
#include <functional>

#include "results/finished_run.hpp"
#include "simulation/run_request.hpp"
#include "simulation/run_session.hpp"

namespace sandgraph::results {

// Draws what the scene asks for once a run has ended; returns one line for the user.
using DrawPictures = std::function<std::string(const FinishedRun&)>;

// Runs a scene with all its outputs: run.h5, load.csv, summary.json, fields.xdmf.
simulation::RunEnd run_scene(const simulation::RunRequest& request, const DrawPictures& draw);

}  // namespace sandgraph::results

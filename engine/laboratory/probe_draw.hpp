#pragma once
#include "laboratory/probe_path.hpp"
#include "scene/probe_spec.hpp"

namespace sandgraph::laboratory {

// A strain path of `kind` drawn at random by (seed of the recipe, `stream`).
ProbePath draw_path(io::HistoryPath kind, const scene::ProbeSpec& spec, std::uint64_t stream);

}  // namespace sandgraph::laboratory

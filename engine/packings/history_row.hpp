#pragma once
#include "graph/rve_law.hpp"
#include "io/history.hpp"
#include "scene/scene.hpp"

namespace sandgraph::packings {

// A DEM update as the history log keeps it; history, sequence, mode and dt are the caller's to fill.
io::HistoryRow history_row(const dem::RveUpdate& update);

// The packing that histories start from; `grains` is its recipe.
io::HistoryPacking history_packing(const graph::RowPacking& row, const stress::PackingTraits& traits,
                                   const scene::Grains& grains);

}  // namespace sandgraph::packings

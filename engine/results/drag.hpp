#pragma once
#include <span>

#include "io/frame.hpp"

namespace sandgraph::results {

// Shares of a plate's load that the numerics carry, not the ground.
struct Drag {
    double damping = 0, pic = 0, inertia = 0;
    double sum() const { return damping + pic + inertia; }
};

// Mean over the rows within `half_width` of d/B, weighted by their loads (of those that resist); 0 where
// there are none. A single row swings with the waves in the ground.
Drag drag_at(std::span<const io::LoadRow> rows, double d_over_B, double half_width = 0.005);

// The largest sum of these about any row from `from` on; before it the load rises, and waves with it.
double largest_drag(std::span<const io::LoadRow> rows, double from = 0.01, double half_width = 0.005);

}  // namespace sandgraph::results

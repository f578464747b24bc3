#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "mpm/points.hpp"
#include "mpm/rectangle.hpp"

namespace sandgraph::simulation {

// Which material points a history log follows: `count` of them, in rising order. Half are spread over the
// whole ground, a quarter lies within 1.5 plate widths `width` [m] of the plate, a quarter within half a
// width of its ends; without a plate all are spread. Drawn by `seed`.
std::vector<std::int32_t> history_points(const mpm::Points& points,
                                         const std::optional<mpm::Rectangle>& plate, double width, int count,
                                         std::uint64_t seed);

}  // namespace sandgraph::simulation

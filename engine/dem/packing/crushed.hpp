#pragma once

namespace sandgraph::dem {

// Grains pressed into each other by about half their radius: below this 2D porosity no contact law holds.
inline constexpr double crushed_porosity = -0.5;

}  // namespace sandgraph::dem

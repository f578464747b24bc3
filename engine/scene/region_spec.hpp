#pragma once
#include <array>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace sandgraph::scene {

// A part of the ground that a run follows by name: the material points that lie in a rectangle before the
// first step, or the one nearest to a place.
struct Region {
    std::string name;
    bool tracked_point = false;  // `at` instead of `x` and `y`
    bool absolute = false;       // x, y in metres in the domain, else in plate widths from the plate's centre
    std::array<double, 2> x{0, 0}, y{0, 0};  // low and high; equal for a tracked point
    std::vector<double>
        packings;  // d/B (without an anchor s) at which the packing nearest to the middle is kept
    InputError::Where where{};
};

}  // namespace sandgraph::scene

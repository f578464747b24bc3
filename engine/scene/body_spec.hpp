#pragma once
#include <array>
#include <cstdint>
#include <numbers>

#include "base/error.hpp"

namespace sandgraph::scene {

enum class Shape : std::uint8_t { rectangle, circle };

// A rigid body in the ground, at its surface or at its base. Lengths in the domain [m].
struct Body {
    Shape shape = Shape::rectangle;
    std::array<double, 2> centre{0, 0}, size{0, 0};  // a circle's size is its diameter, twice
    double friction_angle = std::numbers::pi / 2;    // against soil [rad]
    std::array<double, 2> velocity{0, 0};            // [m/s]
    double travel = 0;                               // [m]; 0: at rest
    double ramp = 0.1;                               // share of the travel over which the speed rises
    InputError::Where where = {};

    bool moves() const { return velocity[0] != 0 || velocity[1] != 0; }
    bool moves_up_or_down() const { return velocity[1] != 0; }
    // Across its motion [m]; the load's width B.
    double width() const { return moves_up_or_down() ? size[0] : size[1]; }
    double low(std::size_t k) const { return centre[k] - 0.5 * size[k]; }
    double high(std::size_t k) const { return centre[k] + 0.5 * size[k]; }
};

}  // namespace sandgraph::scene

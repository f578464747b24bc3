#pragma once
#include <optional>

#include "scene/scene.hpp"

// What cells of a given size make of a limit load, by the cases whose exact load is known.
namespace sandgraph::results {

// Which case of the exact book the loaded body is like.
enum class MeshCase {
    plate,
    trapdoor,
    vertical_plate,
    wall_passive,
    wall_active,
    footing,
    footing_surcharge
};
std::optional<MeshCase> mesh_case(const scene::Scene& scene);

// By how much the load of the scene is too high (negative: too low), as a share of it, for a ground of this
// friction angle [rad]: the stored errors of docs/verification.md at 5 and 10 cells a width, between their
// angles and in the cell linearly, beyond ten cells falling with the cell. NaN for what the book does not
// hold: circles, several points a cell beside walls and footings.
double book_mesh_error(const scene::Scene& scene, double friction_angle);

// Cells a width of the loaded body.
double cells_per_width(const scene::Scene& scene);

}  // namespace sandgraph::results

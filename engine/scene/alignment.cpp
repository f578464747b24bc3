#include "scene/alignment.hpp"

#include <cmath>

namespace sandgraph::scene {
namespace {

// Whether a length ends nearer to a multiple of the cell than midway between two.
bool ends_on_node(double length, double cell) {
    const double cells = length / cell;
    return std::fabs(cells - std::round(cells)) < 0.25;
}

bool horizontal(const Scene& s) { return s.anchor.orientation == Orientation::horizontal; }

// A half model.
bool halved(const Scene& s) {
    const Body* body = s.loaded_body();
    return body ? body->low(0) < 0 && body->shape == Shape::rectangle : s.anchor.present && horizontal(s);
}

}  // namespace

double point_spacing(const Domain& domain) {
    return domain.cell / static_cast<double>(std::lround(std::sqrt(domain.points_per_cell)));
}

bool shifts_x(const Scene& s) {
    if (s.domain.edges == Edges::on_nodes || !s.loaded()) return false;
    const Body* body = s.loaded_body();
    if (!body) return horizontal(s) && ends_on_node(0.5 * s.anchor.width, s.domain.cell);
    return body->moves_up_or_down() && ends_on_node(body->high(0), s.domain.cell);
}

// Upwards the domains of the points must still end on nodes, else the ground's own weight is not in exact
// balance: with four points a cell.
bool shifts_y(const Scene& s) {
    if (s.domain.points_per_cell != 4 || s.domain.edges == Edges::on_nodes || !s.loaded()) return false;
    const Body* body = s.loaded_body();
    if (!body)
        return !horizontal(s) &&
               ends_on_node(s.domain.depth - s.anchor.embedment_ratio * s.anchor.width, s.domain.cell);
    return !body->moves_up_or_down() && body->low(1) > 0 && ends_on_node(body->low(1), s.domain.cell);
}

bool halves_points(const Scene& s) {
    return s.domain.edges == Edges::between_nodes && s.domain.points_per_cell == 1;
}

bool columns_on_sides(const Scene& s) {
    if (!halved(s)) return false;
    if (halves_points(s)) return shifts_x(s);
    return std::lround(s.anchor.width / point_spacing(s.domain)) % 2 == 1;
}

}  // namespace sandgraph::scene

#include "results/mesh_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "scene/alignment.hpp"

namespace sandgraph::results {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kDegrees = 180 / std::numbers::pi;

// Errors at 20, 30 and 40 deg of friction, associated [%]: tests/verification/run.sh.
struct Row {
    MeshCase of;
    int points;
    std::array<double, 3> five, ten;  // cells a width
};
constexpr auto kBook = std::to_array<Row>({
    {MeshCase::plate, 1, {2.5, 1.8, 0.1}, {0.5, 0.0, -1.2}},
    {MeshCase::plate, 4, {1.6, 1.5, 0.3}, {-0.1, 0.6, -0.6}},
    {MeshCase::trapdoor, 1, {2.0, 1.1, -1.0}, {0.5, -0.1, -1.6}},
    {MeshCase::trapdoor, 4, {1.4, 0.6, -1.2}, {0.7, 0.4, -1.1}},
    {MeshCase::vertical_plate, 1, {42.1, 26.1, 19.2}, {19.0, 12.0, 8.7}},
    {MeshCase::wall_passive, 1, {10.2, 8.1, 7.3}, {4.0, 3.8, 3.9}},
    {MeshCase::wall_active, 1, {-21.8, -27.4, -38.3}, {-12.0, -14.9, -21.6}},
    {MeshCase::footing, 1, {70.1, 23.7, -6.3}, {52.5, 15.7, 8.3}},
    {MeshCase::footing_surcharge, 1, {-11.2, -13.9, -17.0}, {-4.2, -5.3, -7.3}},
});

const Row* row_of(MeshCase of, int points) {
    const auto row =
        std::ranges::find_if(kBook, [&](const Row& r) { return r.of == of && r.points == points; });
    return row == kBook.end() ? nullptr : &*row;
}

double at_angle(const std::array<double, 3>& errors, double degrees) {
    const double place = std::clamp((degrees - 20) / 10, 0.0, 2.0);
    const auto below = std::min<std::size_t>(static_cast<std::size_t>(place), 1);
    const double share = place - static_cast<double>(below);
    return (1 - share) * errors[below] + share * errors[below + 1];
}

MeshCase case_of(const scene::Scene& s, const scene::Body& body) {
    const bool on_surface = body.high(1) > s.domain.depth;
    if (!body.moves_up_or_down())
        return body.velocity[0] > 0 ? MeshCase::wall_passive : MeshCase::wall_active;
    if (body.velocity[1] > 0 || !on_surface) return body.low(1) <= 0 ? MeshCase::trapdoor : MeshCase::plate;
    return s.ground.gravity == 0 ? MeshCase::footing_surcharge : MeshCase::footing;
}

}  // namespace

std::optional<MeshCase> mesh_case(const scene::Scene& s) {
    const scene::Body* body = s.loaded_body();
    if (body) return body->shape == scene::Shape::circle ? std::nullopt : std::optional(case_of(s, *body));
    if (!s.anchor.present) return std::nullopt;
    return s.anchor.orientation == scene::Orientation::horizontal ? MeshCase::plate
                                                                  : MeshCase::vertical_plate;
}

double cells_per_width(const scene::Scene& s) { return s.anchor.width / s.domain.cell; }

double book_mesh_error(const scene::Scene& s, double friction_angle) {
    const auto of = mesh_case(s);
    const Row* row = of ? row_of(*of, s.domain.points_per_cell) : nullptr;
    if (!row || s.domain.edges == scene::Edges::on_nodes || !(friction_angle > 0)) return kUnknown;
    const double five = at_angle(row->five, friction_angle * kDegrees),
                 ten = at_angle(row->ten, friction_angle * kDegrees);
    const double cells = cells_per_width(s);
    if (cells >= 10) return 0.01 * ten * 10 / cells;
    if (cells <= 5) return 0.01 * five * 5 / cells;
    return 0.01 * (ten + (five - ten) * (10 / cells - 1));
}

}  // namespace sandgraph::results

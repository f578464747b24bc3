#include "report/field_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

namespace sandgraph::report {
namespace {

constexpr double overlap = 1.04;         // of drawn squares: no hairlines between neighbours
constexpr double widest_stretch = 1.6;   // of a drawn square; beyond, gaps are real
constexpr double shortest_arrow = 0.03;  // as a share of the longest

struct Square {
    double x, y, half_x, half_y, value;
};

double drawn_stretch(double F) { return std::clamp(std::abs(F), 1.0, widest_stretch); }

Square square(const io::Frame& frame, const results::PointValues& shown, const results::GroundView& view,
              std::size_t p) {
    const double half = overlap * view.point_size / 2;
    Square s{frame.x[p], frame.y[p], half, half, shown.values[p]};
    if (!results::has_field(frame, "F")) return s;
    const Mat2 F = results::deformation_gradient(results::field(frame, "F", 4), p);
    s.half_x *= drawn_stretch(F(0, 0));
    s.half_y *= drawn_stretch(F(1, 1));
    return s;
}

std::string row(const Square& s) {
    return fmt::format("{:.6g} {:.6g} {:.4g} {:.4g} {:.6g}\n", s.x, s.y, s.half_x, s.half_y, s.value);
}

// The bin of a point in the middle half of it; points near the edges would give uneven arrows.
std::optional<std::pair<long, long>> central_bin(double x, double y, double spacing) {
    const double i = x / spacing, j = y / spacing;
    if (std::abs(i - std::floor(i) - 0.5) > 0.25 || std::abs(j - std::floor(j) - 0.5) > 0.25)
        return std::nullopt;
    return std::pair(std::lround(std::floor(i)), std::lround(std::floor(j)));
}

double longest(const io::Field& u) {
    double result = 0;
    for (std::size_t k = 0; k + 1 < u.values.size(); k += 2)
        result = std::max(result, std::hypot(u.values[k], u.values[k + 1]));
    return result;
}

}  // namespace

std::string square_rows(const io::Frame& frame, const results::PointValues& shown,
                        const results::GroundView& view) {
    std::string text;
    for (std::size_t p = 0; p < frame.x.size(); ++p) {
        Square s = square(frame, shown, view, p);
        if (!std::isfinite(s.value)) continue;
        text += row(s);
        if (!view.mirror) continue;
        s.x = -s.x;
        if (shown.is_signed) s.value = -s.value;
        text += row(s);
    }
    return text;
}

std::string arrow_rows(const io::Frame& frame, const results::GroundView& view, double spacing) {
    const io::Field& u = results::field(frame, "displacement", 2);
    const double most = longest(u);
    std::set<std::pair<long, long>> taken;  // bins that have their arrow
    std::string text;
    for (std::size_t p = 0; p < frame.x.size() && most > 0; ++p) {
        const double dx = u.values[2 * p] / most, dy = u.values[2 * p + 1] / most;
        if (std::hypot(dx, dy) < shortest_arrow) continue;
        const auto bin = central_bin(frame.x[p], frame.y[p], spacing);
        if (!bin || !taken.insert(*bin).second) continue;
        const auto arrow = [&](double side) {
            text += fmt::format("{:.5g} {:.5g} {:.4g} {:.4g}\n", side * frame.x[p], frame.y[p],
                                side * spacing * dx, spacing * dy);
        };
        arrow(1);
        if (view.mirror) arrow(-1);
    }
    return text;
}

}  // namespace sandgraph::report

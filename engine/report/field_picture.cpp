#include "report/field_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "report/colour_scale.hpp"

namespace sandgraph::report {
namespace {

struct Box {
    double left, right, bottom, top;
};

Box box_of(const io::Frame& frame, const results::GroundView& view) {
    double top = view.surface;
    for (const double y : frame.y) top = std::max(top, y);
    const double margin = 0.02 * (view.window > 0 ? view.window : view.width);
    const double left = view.mirror ? -view.width : 0;
    if (view.window > 0) {
        const double low = frame.plate_y - 0.5 * view.plate_size_y - 0.4 * view.window;
        return {std::max(left, frame.plate_x - view.window) - margin,
                std::min(view.width, frame.plate_x + view.window) + margin, std::max(0.0, low) - margin,
                top + 2 * margin};
    }
    return {left - margin, view.width + margin, -margin, top + 2 * margin};
}

std::string title(const io::Frame& frame, const results::GroundView& view) {
    return literal(fmt::format("{}, {}{}", view.title,
                               results::moment_text(results::mark_of(frame, view), view.has_plate),
                               view.mirror ? " (left half: mirror image)" : ""));
}

// A second axis above in plate widths.
std::string axis_in_widths(const results::GroundView& view) {
    if (!view.has_plate) return "";
    return fmt::format("set link x2 via x/{} inverse x*{}\nset x2tics\nset x2label 'x/B' offset 0,-0.4\n",
                       view.anchor_width, view.anchor_width);
}

std::string axes(const io::Frame& frame, const results::GroundView& view, const Box& box) {
    return fmt::format(
        "set title {} noenhanced offset 0,0.4\nset size ratio -1\nset xrange [{}:{}]\nset yrange [{}:{}]\n"
        "set xlabel 'x [m]'\nset ylabel 'y [m]'\nset xtics nomirror\nset ytics nomirror\nset tics out\n"
        "{}unset key\nset clip two\n",
        title(frame, view), box.left, box.right, box.bottom, box.top, axis_in_widths(view));
}

// One colour a kind, named beside it.
std::string kind_colours(const results::PointValues& shown) {
    std::string steps, ticks;
    for (std::size_t k = 0; k < shown.kinds.size(); ++k) {
        const char *comma = k > 0 ? ", " : "", *colour = kind_colour(k);
        steps += fmt::format("{}{} '{}', {} '{}'", comma, k, colour, k + 1, colour);
        ticks += fmt::format("{}{} {}", comma, literal(shown.kinds[k]), k);
    }
    return fmt::format("set palette defined ({})\nset cbrange [-0.5:{}]\nset cbtics ({})\n", steps,
                       static_cast<double>(shown.kinds.size()) - 0.5, ticks);
}

std::string scale_colours(const results::PointValues& shown, const ColourRange& range) {
    const char* beyond = range.clipped_low && range.clipped_high ? ", some points beyond"
                         : range.clipped_high                    ? ", some points above"
                         : range.clipped_low                     ? ", some points below"
                                                                 : "";
    return palette(shown.is_signed) +
           fmt::format("set cbrange [{}:{}]\nset cblabel {} offset 0.5,0\n", range.low, range.high,
                       literal(fmt::format("{} [{}]{}", shown.name, shown.unit, beyond)));
}

std::string colours(const results::PointValues& shown, const ColourRange& range) {
    // Kinds are told in words beside the colours.
    return shown.kinds.empty() ? scale_colours(shown, range) + "set rmargin at screen 0.83\n"
                               : kind_colours(shown) + "set rmargin at screen 0.8\n";
}

std::string plate(const io::Frame& frame, const results::GroundView& view) {
    if (!view.has_plate) return {};
    const double hx = view.plate_size_x / 2, hy = view.plate_size_y / 2;
    const double left = frame.plate_x - hx, right = frame.plate_x + hx;
    return fmt::format("set object 1 rectangle from {},{} to {},{} fc rgb 'black' fs solid noborder front\n",
                       view.mirror || frame.plate_x > 0 ? left : std::max(left, 0.0), frame.plate_y - hy,
                       right, frame.plate_y + hy);
}

std::string surface_line(const results::GroundView& view) {
    return fmt::format("{} {}\n{} {}\n", view.mirror ? -view.width : 0.0, view.surface, view.width,
                       view.surface);
}

std::string plot_command(bool arrows) {
    std::string text =
        "plot 'squares.txt' using 1:2:3:4:5 with boxxyerror fs solid border lw 0.4 lc palette, "
        "'surface.txt' using 1:2 with lines dt 2 lw 1.5 lc rgb 'black'";
    if (arrows)
        text +=
            ", \\\n     'arrows.txt' using 1:2:3:4 with vectors head size screen 0.004,20 filled lw 0.8 lc "
            "rgb '#50000000'";
    return text + "\n";
}

// The picture's height follows the box, so that equal scales leave no blank bands.
void fit_size(Plot& plot, const Box& box) {
    const double room_x = 230, room_y = 170;  // axes, title, colour bar [px]
    const double scale = (plot.width - room_x) / (box.right - box.left);
    plot.height = static_cast<int>(std::clamp(scale * (box.top - box.bottom) + room_y, 350.0, 1600.0));
}

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

Plot field_plot(const io::Frame& frame, results::Quantity quantity, const results::GroundView& view) {
    const results::PointValues shown = results::point_values(frame, quantity);
    const Box box = box_of(frame, view);
    const ColourRange range =
        colour_range(shown.values, shown.is_signed, quantity != results::Quantity::porosity);
    Plot plot;
    fit_size(plot, box);
    plot.data.emplace_back("squares.txt", square_rows(frame, shown, view));
    plot.data.emplace_back("surface.txt", surface_line(view));
    if (quantity == results::Quantity::displacement)
        plot.data.emplace_back("arrows.txt", arrow_rows(frame, view, (box.right - box.left) / 36));
    const bool arrows = plot.data.back().first == "arrows.txt" && !plot.data.back().second.empty();
    plot.script = axes(frame, view, box) + colours(shown, range) + plate(frame, view) + plot_command(arrows);
    return plot;
}

Picture draw_field_picture(const io::Frame& frame, results::Quantity quantity,
                           const results::GroundView& view, const std::filesystem::path& png) {
    try {
        return draw(field_plot(frame, quantity, view), png);
    } catch (const std::exception& error) {
        return {false, fmt::format("{}: no picture: {}", png.string(), error.what())};
    }
}

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

#include "report/field_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace sandgraph::report {
namespace {

using results::Quantity;

constexpr int room_x = 260, room_y = 165, line_height = 24;  // axes, colour bar; a line of the title [px]
constexpr int room_right = 158, room_kinds = 180;  // of room_x: colour bar with its numbers or words
constexpr int narrowest = 460, lowest = 330, highest = 1100;
constexpr double arrows_across = 30;
constexpr double at_rest = 0.01;         // of the range of colours: shorter displacements have no arrow
constexpr double shortest_arrow = 0.08;  // as a share of the longest

// What is shown, depth downwards [m].
struct Box {
    double left, right, top, bottom;
    double width() const { return right - left; }
};

double spacing_of(double width, double point_size) {
    return point_size * std::max(1.0, std::round(width / arrows_across / point_size));
}

// Arrows at the surface need a spacing of air.
Box box_of(const io::Frame& frame, const results::GroundView& view) {
    double top = 0;
    for (const double y : frame.y) top = std::min(top, view.surface - y);
    const double margin = 0.02 * (view.window > 0 ? view.window : view.width);
    Box box{(view.mirror ? -view.width : 0) - margin, view.width + margin, top, view.surface + margin};
    if (view.window > 0) {
        box.left = std::max(box.left, frame.plate_x - view.window - margin);
        box.right = std::min(box.right, frame.plate_x + view.window + margin);
        const double under_plate = view.surface - frame.plate_y + 0.5 * view.plate_size_y;
        box.bottom = std::min(view.surface, under_plate + 0.4 * view.window) + margin;
    }
    box.top -= std::max(2 * margin, 1.1 * spacing_of(box.width(), view.point_size));
    return box;
}

ValueKind kind_of(Quantity quantity) {
    switch (quantity) {
        case Quantity::rotation:
            return ValueKind::signed_value;
        case Quantity::porosity:
            return ValueKind::level;
        default:
            return ValueKind::magnitude;
    }
}

// Below it is the noise of a ground at rest.
double least_range(Quantity quantity, const results::GroundView& view) {
    switch (quantity) {
        case Quantity::displacement:
            return 1e-4 * view.anchor_width;
        case Quantity::rotation:
            return 0.1;
        case Quantity::porosity:
            return 0.01;
        default:
            return 1e-3;
    }
}

// Without gnuplot's markup.
std::string plain(std::string name) {
    std::erase_if(name, [](char c) { return c == '{' || c == '}'; });
    return name;
}

std::vector<std::string> title_lines(const io::Frame& frame, const results::PointValues& shown,
                                     const results::GroundView& view, const ColourRange& range, int width) {
    std::vector<std::string> lines = lines_of(view.title, width);
    const std::string moment = fmt::format(
        "{}: {}{}{}", results::moment_text(results::mark_of(frame, view), view.has_plate), plain(shown.name),
        view.mirror ? ", left half mirrored" : "", shown.kinds.empty() ? beyond(range, shown.values) : "");
    for (std::string& line : lines_of(moment, width)) lines.push_back(std::move(line));
    return lines;
}

std::string title(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += (text.empty() ? "" : ".\"\\n\".") + literal(line);
    return text;
}

// A second axis above in plate widths.
std::string axis_in_widths(const results::GroundView& view) {
    if (!view.has_plate) return "";
    return fmt::format(
        "set link x2 via x/{} inverse x*{}\nset x2tics offset 0,-0.3\nset x2label 'x/B' offset 0,-1\n",
        view.anchor_width, view.anchor_width);
}

std::string axes(const results::GroundView& view, const Box& box) {
    return fmt::format(
        "set size ratio -1\nset xrange [{}:{}]\nset yrange [{}:{}]\n"
        "set xlabel 'x [m]'\nset ylabel 'depth below the surface [m]'\nset xtics nomirror\nset ytics "
        "nomirror\n"
        "set tics out\n{}unset key\nset clip two\n",
        box.left, box.right, box.bottom, box.top, axis_in_widths(view));
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

std::string scale_colours(const results::PointValues& shown, Quantity quantity, const ColourRange& range) {
    return palette(kind_of(quantity)) +
           fmt::format("set cbrange [{}:{}]\nset format cb '%g'\nset cblabel {} offset 0.5,0\n", range.low,
                       range.high, literal(fmt::format("{} [{}]", shown.name, shown.unit)));
}

std::string plate(const io::Frame& frame, const results::GroundView& view) {
    if (!view.has_plate) return {};
    const double hx = view.plate_size_x / 2, hy = view.plate_size_y / 2;
    const double left = frame.plate_x - hx, right = frame.plate_x + hx, depth = view.surface - frame.plate_y;
    return fmt::format("set object 1 rectangle from {},{} to {},{} fc rgb 'black' fs solid noborder front\n",
                       view.mirror || frame.plate_x > 0 ? left : std::max(left, 0.0), depth + hy, right,
                       depth - hy);
}

// Under the axis on the right.
std::string arrow_legend(const ArrowScale& scale, const Box& box, int height) {
    const double left = box.right - scale.length * scale.shown;
    return fmt::format(
        "set arrow 1 from first {0}, screen {3} to first {1}, screen {3} head size screen 0.008,20 "
        "filled "
        "lw 1.2 lc rgb 'black'\n"
        "set label 1 {2} at first {0}, screen {3} right offset -0.7,0\n",
        left, box.right, literal(fmt::format("{:g} m", scale.shown)), 22.0 / height);
}

std::string surface_line(const results::GroundView& view) {
    return fmt::format("{} 0\n{} 0\n", view.mirror ? -view.width : 0.0, view.width);
}

std::string plot_command(bool arrows) {
    std::string text =
        "plot 'squares.txt' using 1:2:3:4:5 with boxxyerror fs solid border lw 0.4 lc palette, "
        "'surface.txt' using 1:2 with lines dt 2 lw 1.5 lc rgb 'black'";
    if (arrows)
        text +=
            ", \\\n     'arrows.txt' using 1:2:3:4 with vectors head size screen 0.006,20 filled lw 0.9 lc "
            "rgb '#303030'";
    return text + "\n";
}

// The picture's size follows the box, so that equal scales leave no blank bands.
void fit_size(Plot& plot, const Box& box) {
    const double shape = (box.bottom - box.top) / box.width();
    const double across = std::min(double(plot.width - room_x), (highest - room_y) / shape);
    plot.width = std::max(narrowest, static_cast<int>(across) + room_x);
    plot.height = std::max(lowest, static_cast<int>(across * shape) + room_y);
}

std::string margins(const Plot& plot, std::size_t title_lines, bool kinds) {
    return fmt::format(
        "set tmargin at screen {}\nset bmargin at screen {}\nset lmargin at screen {}\nset rmargin at screen "
        "{}\n",
        1 - (85.0 + line_height * static_cast<double>(title_lines)) / plot.height, 80.0 / plot.height,
        95.0 / plot.width, 1 - double(kinds ? room_kinds : room_right) / plot.width);
}

constexpr double overlap = 1.04;        // of drawn squares: no hairlines between neighbours
constexpr double widest_stretch = 1.6;  // of a drawn square; beyond, gaps are real

struct Square {
    double x, depth, half_x, half_y, value;
};

double drawn_stretch(double F) { return std::clamp(std::abs(F), 1.0, widest_stretch); }

Square square(const io::Frame& frame, const results::PointValues& shown, const results::GroundView& view,
              std::size_t p) {
    const double half = overlap * view.point_size / 2;
    Square s{frame.x[p], view.surface - frame.y[p], half, half, shown.values[p]};
    if (!results::has_field(frame, "F")) return s;
    const Mat2 F = results::deformation_gradient(results::field(frame, "F", 4), p);
    s.half_x *= drawn_stretch(F(0, 0));
    s.half_y *= drawn_stretch(F(1, 1));
    return s;
}

std::string row(const Square& s) {
    return fmt::format("{:.6g} {:.6g} {:.4g} {:.4g} {:.6g}\n", s.x, s.depth, s.half_x, s.half_y, s.value);
}

// Of all points in a bin of the ground before the pull.
struct MeanMove {
    double x = 0, y = 0, dx = 0, dy = 0;  // where they are now, and how far they have come
    int points = 0;
};

std::map<std::pair<long, long>, MeanMove> mean_moves(const io::Frame& frame, double spacing) {
    const io::Field& u = results::field(frame, "displacement", 2);
    std::map<std::pair<long, long>, MeanMove> moves;
    for (std::size_t p = 0; p < frame.x.size(); ++p) {
        const double dx = u.values[2 * p], dy = u.values[2 * p + 1];
        const double i = (frame.x[p] - dx) / spacing, j = (frame.y[p] - dy) / spacing;
        if (!std::isfinite(i + j)) continue;
        MeanMove& m = moves[{std::lround(std::floor(i)), std::lround(std::floor(j))}];
        m.x += frame.x[p], m.y += frame.y[p], m.dx += dx, m.dy += dy, ++m.points;
    }
    for (auto& [bin, m] : moves) m.x /= m.points, m.y /= m.points, m.dx /= m.points, m.dy /= m.points;
    return moves;
}

double longest(const io::Field& u) {
    double result = 0;
    for (std::size_t k = 0; k + 1 < u.values.size(); k += 2)
        result = std::max(result, std::hypot(u.values[k], u.values[k + 1]));
    return result;
}

}  // namespace

ColourRange field_range(const io::Frame& frame, Quantity quantity, const results::GroundView& view) {
    return colour_range(results::point_values(frame, quantity).values, kind_of(quantity),
                        least_range(quantity, view));
}

Plot field_plot(const io::Frame& frame, Quantity quantity, const results::GroundView& view,
                const ColourRange& range) {
    const results::PointValues shown = results::point_values(frame, quantity);
    const Box box = box_of(frame, view);
    Plot plot;
    fit_size(plot, box);
    const std::vector<std::string> lines = title_lines(frame, shown, view, range, plot.width - 20);
    plot.height += line_height * static_cast<int>(lines.size());
    plot.data = {{"squares.txt", square_rows(frame, shown, view)}, {"surface.txt", surface_line(view)}};
    plot.script = fmt::format("set title {} noenhanced\n", title(lines)) + axes(view, box) +
                  margins(plot, lines.size(), !shown.kinds.empty()) +
                  (shown.kinds.empty() ? scale_colours(shown, quantity, range) : kind_colours(shown)) +
                  plate(frame, view);
    ArrowScale scale;
    if (quantity == Quantity::displacement) scale = arrow_scale(frame, view, range);
    if (scale.shown > 0) {
        plot.data.emplace_back("arrows.txt", arrow_rows(frame, view, scale));
        plot.script += arrow_legend(scale, box, plot.height);
    }
    plot.script += plot_command(scale.shown > 0);
    return plot;
}

Picture draw_field_picture(const io::Frame& frame, Quantity quantity, const results::GroundView& view,
                           const ColourRange& range, const std::filesystem::path& png,
                           const std::vector<std::string>& formats) {
    try {
        return draw_formats(field_plot(frame, quantity, view, range), png, formats);
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

ArrowScale arrow_scale(const io::Frame& frame, const results::GroundView& view, const ColourRange& range) {
    const double most = longest(results::field(frame, "displacement", 2));
    ArrowScale scale;
    scale.spacing = spacing_of(box_of(frame, view).width(), view.point_size);
    if (!(most > at_rest * range.high)) return scale;
    scale.length = scale.spacing / most;
    scale.least = std::max(shortest_arrow * most, at_rest * range.high);
    scale.shown = round_step(2 * most, 1);
    return scale;
}

std::string arrow_rows(const io::Frame& frame, const results::GroundView& view, const ArrowScale& scale) {
    if (scale.shown <= 0) return "";
    std::string text;
    for (const auto& [bin, m] : mean_moves(frame, scale.spacing)) {
        if (std::hypot(m.dx, m.dy) < scale.least) continue;
        const auto arrow = [&](double side) {
            text += fmt::format("{:.5g} {:.5g} {:.4g} {:.4g}\n", side * m.x, view.surface - m.y,
                                side * scale.length * m.dx, -scale.length * m.dy);
        };
        arrow(1);
        if (view.mirror) arrow(-1);
    }
    return text;
}

}  // namespace sandgraph::report

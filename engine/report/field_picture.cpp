#include "report/field_picture.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/colour_scale.hpp"
#include "report/field_rows.hpp"

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
    return (shown.kinds.empty() ? scale_colours(shown, range) : kind_colours(shown)) +
           "set rmargin at screen 0.83\n";
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

}  // namespace sandgraph::report

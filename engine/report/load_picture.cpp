#include "report/load_picture.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/colour_scale.hpp"

namespace sandgraph::report {
namespace {

constexpr std::size_t labelled_curves = 3;
constexpr double bin =
    0.004;  // d/B over which each of many curves is averaged: dashes of a jagged line say nothing

std::string file_name(std::size_t k) { return fmt::format("curve{}.txt", k); }

// Means over stretches of `length` in d/B; 0: every point.
std::string rows(const LoadCurve& curve, double length) {
    std::string text;
    for (std::size_t k = 0, end = 0; k < curve.d_over_B.size(); k = end) {
        double d = 0, load = 0;
        for (end = k;
             end < curve.d_over_B.size() && (end == k || curve.d_over_B[end] - curve.d_over_B[k] < length);
             ++end)
            d += curve.d_over_B[end], load += curve.load[end];
        const auto n = static_cast<double>(end - k);
        text += fmt::format("{} {}\n", d / n, load / n / curve.unit_load);
    }
    return text;
}

double last_displacement(const std::vector<LoadCurve>& curves) {
    double last = 0;
    for (const LoadCurve& c : curves)
        if (!c.d_over_B.empty()) last = std::max(last, c.d_over_B.back());
    return last;
}

double largest_load(const std::vector<LoadCurve>& curves) {
    double largest = 0;
    for (const LoadCurve& c : curves)
        for (const double load : c.load) largest = std::max(largest, load);
    return largest;
}

// The second axis, with round ticks of its own in kN/m.
std::string load_axis(const std::vector<LoadCurve>& curves) {
    const double unit = curves.front().unit_load / 1000, largest = largest_load(curves) / 1000;
    return fmt::format(
        "set link y2 via y*{0} inverse y/{0}\nset y2tics {1}\nset ytics nomirror\nset y2label 'load Q "
        "[kN/m]'\n",
        unit, largest > 0 ? round_step(largest, 5) : 1);
}

bool share_unit_load(const std::vector<LoadCurve>& curves) {
    return !curves.empty() && std::all_of(curves.begin(), curves.end(), [&](const LoadCurve& c) {
        return c.unit_load == curves.front().unit_load;
    });
}

std::string axes(const LoadPicture& picture) {
    const double last = last_displacement(picture.curves);
    std::string text = fmt::format(
        "set title {} noenhanced\nset xlabel 'displacement d/B'\nset ylabel 'breakout factor N_γ = Q/(BγH)'\n"
        "set grid lt 1 lw 0.6 lc rgb '#e4e4e4'\nset key bottom right noenhanced\nset xrange [0:{}]\nset "
        "yrange [0:*]\n"
        "set offsets graph 0, 0, graph 0.08, 0\n",
        literal(picture.title), last > 0 ? fmt::format("{}", last) : "*");
    if (share_unit_load(picture.curves)) text += load_axis(picture.curves);
    return text;
}

std::string reference_labels(const std::vector<ReferenceLine>& references) {
    std::string text;
    for (const ReferenceLine& r : references)
        text += fmt::format(
            "set label {} at graph 0.98, first {} right offset 0,0.6 noenhanced textcolor '#444444' front\n",
            literal(fmt::format("{}: {:.2f}", r.label, r.n_gamma)), r.n_gamma);
    return text;
}

// Where the words beside a dot stand: above a reference line that would run through them.
double clear_of(const std::vector<ReferenceLine>& references, double n) {
    for (const ReferenceLine& r : references)
        if (r.n_gamma > 0.99 * n && r.n_gamma < 1.1 * n) n = r.n_gamma;
    return n;
}

// Of many curves the dots alone, or their words would cover each other.
std::string breakout_label(const LoadCurve& curve, std::size_t k, bool many, const LoadPicture& picture) {
    const double at = curve.breakout.d_over_B, n = curve.breakout.load / curve.unit_load;
    if (at <= 0) return {};
    const std::string dot =
        fmt::format("set label '' at {},{} point pt 7 ps 1.5 lc rgb '{}' front\n", at, n, series_colour(k));
    if (many) return dot;
    const char* word = curve.breakout.kind == results::BreakoutKind::still_rising ? "still rising, " : "";
    // Before the curve's end below the dot, where no reference line is.
    const bool late = at > 0.5 * last_displacement(picture.curves);
    return dot + fmt::format("set label {} at {},{} {} noenhanced textcolor '{}' front\n",
                             literal(fmt::format("{}{:.2f} at d/B = {:.3f}", word, n, at)), at,
                             late ? n : clear_of(picture.references, n),
                             late ? "right offset -1,-3" : "left offset 1,0.8", series_colour(k));
}

std::string curve_item(const LoadCurve& curve, std::size_t k) {
    return fmt::format("'{}' using 1:2 with lines lw 2 lc rgb '{}' dt {} title {}", file_name(k),
                       series_colour(k), 1 + k / series_colours.size() % 5, literal(curve.label));
}

std::string reference_item(const ReferenceLine& r) {
    return fmt::format("{} with lines dt 2 lw 1.5 lc rgb '#444444' notitle", r.n_gamma);
}

}  // namespace

Plot load_plot(const LoadPicture& picture) {
    Plot plot;
    plot.script = axes(picture) + reference_labels(picture.references);
    const bool many = picture.curves.size() > labelled_curves;
    if (many) plot.width = 1500, plot.script += "set key outside right top\n";
    std::string items;
    const auto add = [&](const std::string& item) {
        items += (items.empty() ? "plot " : ", \\\n     ") + item;
    };
    for (std::size_t k = 0; k < picture.curves.size(); ++k) {
        plot.script += breakout_label(picture.curves[k], k, many, picture);
        plot.data.emplace_back(file_name(k), rows(picture.curves[k], many ? bin : 0));
        add(curve_item(picture.curves[k], k));
    }
    for (const ReferenceLine& r : picture.references) add(reference_item(r));
    plot.script += items + "\n";
    return plot;
}

Picture draw_load_picture(const LoadPicture& picture, const std::filesystem::path& png) {
    return draw(load_plot(picture), png);
}

}  // namespace sandgraph::report

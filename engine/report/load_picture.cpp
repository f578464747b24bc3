#include "report/load_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "report/colour_scale.hpp"

namespace sandgraph::report {
namespace {

constexpr std::size_t few_curves = 3;
constexpr double least_gap = 0.05;    // of the axis, between lines whose words would cover each other
constexpr double marks_a_curve = 12;  // that tell curves of one colour apart

std::string file_name(std::size_t k) { return fmt::format("curve{}.txt", k); }

bool has_bar(const LoadCurve& curve) { return curve.corrected.size() == curve.load.size(); }

std::string rows(const LoadCurve& curve) {
    std::string text;
    for (std::size_t k = 0; k < curve.d_over_B.size(); ++k) {
        text += fmt::format("{} {}", curve.d_over_B[k], curve.load[k] / curve.unit_load);
        if (has_bar(curve))
            for (const double load : {curve.corrected[k], curve.low[k], curve.high[k]})
                text += fmt::format(" {}", load / curve.unit_load);
        text += "\n";
    }
    return text;
}

// The end of the displacement axis, a round number.
double last_displacement(const std::vector<LoadCurve>& curves) {
    double last = 0;
    for (const LoadCurve& c : curves)
        if (!c.d_over_B.empty()) last = std::max(last, c.d_over_B.back());
    if (!(last > 0)) return 1;
    const double step = round_step(last, 10);
    return step * std::ceil(last / step - 1e-6);
}

struct Extent {
    double low = 0, high = 0;  // of N
};

Extent extent_of(const LoadPicture& picture) {
    Extent e;
    for (const LoadCurve& c : picture.curves)
        for (const auto* loads : {&c.load, &c.low, &c.high})
            for (const double load : *loads)
                if (std::isfinite(load))
                    e.low = std::min(e.low, load / c.unit_load),
                    e.high = std::max(e.high, load / c.unit_load);
    for (const ReferenceLine& r : picture.references) e.high = std::max(e.high, r.n_gamma);
    if (!(e.high > 0)) e.high = e.low < 0 ? 0 : 1;
    if (e.low > -0.1 * e.high) e.low = 0;  // of the first moments
    const double room = e.high - e.low;
    return {e.low < 0 ? e.low - 0.03 * room : 0, e.high + 0.1 * room};
}

// The second axis, with round ticks of its own in kN/m.
std::string load_axis(const std::vector<LoadCurve>& curves, const Extent& e) {
    const double unit = curves.front().unit_load / 1000;
    return fmt::format(
        "set link y2 via y*{0} inverse y/{0}\nset y2tics {1}\nset ytics nomirror\nset y2label 'load Q "
        "[kN/m]'\n",
        unit, round_step(unit * (e.high - e.low), 5));
}

bool share_unit_load(const std::vector<LoadCurve>& curves) {
    return !curves.empty() && std::all_of(curves.begin(), curves.end(), [&](const LoadCurve& c) {
        return c.unit_load == curves.front().unit_load;
    });
}

std::string axes(const LoadPicture& picture, const Extent& e, int width) {
    std::string text = fmt::format(
        "set title {} noenhanced\nset xlabel 'displacement d/B'\nset ylabel 'breakout factor N_γ = Q/(BγH)'\n"
        "set grid lt 1 lw 0.6 lc rgb '#e4e4e4'\nset key noenhanced\nset xrange [0:{}]\nset "
        "yrange [{}:{}]\nset xzeroaxis lt 1 lw 1 lc rgb '#888888'\n"
        "set style textbox opaque fc rgb 'white' noborder margins 0.4,0.2\n",
        wrapped(picture.title, width - 20), last_displacement(picture.curves), e.low, e.high);
    if (share_unit_load(picture.curves)) text += load_axis(picture.curves, e);
    return text;
}

// Words above the line, of a line close under another one below it.
std::string reference_labels(std::vector<ReferenceLine> references, const Extent& e) {
    std::string text;
    std::ranges::sort(references, std::greater(), &ReferenceLine::n_gamma);
    double above = std::numeric_limits<double>::infinity();
    for (const ReferenceLine& r : references) {
        const bool close = above - r.n_gamma < least_gap * (e.high - e.low);
        text += fmt::format(
            "set label {} at graph 0.98, first {} right offset 0,{} noenhanced boxed textcolor '#444444' "
            "front\n",
            literal(fmt::format("{}: {:.2f}", r.label, r.n_gamma)), r.n_gamma, close ? -0.8 : 0.8);
        above = r.n_gamma;
    }
    return text;
}

// Beside the dot, on the side where there is room, clear of the reference lines' words on the right, and
// above the axis.
std::string words_at(const LoadPicture& picture, const Extent& e, double at, double n) {
    const bool late = at > 0.5 * last_displacement(picture.curves);
    const auto line_near = [&](double low, double high) {
        return std::ranges::any_of(picture.references, [&](const ReferenceLine& r) {
            return r.n_gamma > n + low * (e.high - e.low) && r.n_gamma < n + high * (e.high - e.low);
        });
    };
    const bool low = n - e.low < 0.15 * (e.high - e.low);
    const bool below = !low && (line_near(-0.01, 0.12) || late);
    return fmt::format("{} offset {},{}", late ? "right" : "left", late ? -1 : 1,
                       !below ? 1
                       : late ? -4
                              : -2.6);
}

std::string breakout_words(const LoadCurve& curve) {
    const char* word = curve.breakout.kind == results::BreakoutKind::still_rising ? "still rising, " : "";
    return fmt::format("{}{:.2f} at d/B = {:.3f}", word, curve.breakout.load / curve.unit_load,
                       curve.breakout.d_over_B);
}

// Of several curves the dots alone, for their words would cover each other: those stand in the key.
std::string breakout_label(const LoadCurve& curve, std::size_t k, const LoadPicture& picture,
                           const Extent& e) {
    const double at = curve.breakout.d_over_B, n = curve.breakout.load / curve.unit_load;
    if (at <= 0) return {};
    const std::string dot =
        fmt::format("set label '' at {},{} point pt 7 ps 1.2 lc rgb '{}' front\n", at, n, series_colour(k));
    if (picture.curves.size() > 1) return dot;
    return dot + fmt::format("set label {} at {},{} {} noenhanced textcolor '{}' front\n",
                             literal(breakout_words(curve)), at, n, words_at(picture, e, at, n),
                             series_colour(k));
}

// Marks tell curves of one colour apart: dashes of a jagged line say nothing.
std::string style(const LoadCurve& curve, std::size_t k) {
    const std::size_t round = k / series_colours.size();
    const std::string line = fmt::format("lw 1.6 lc rgb '{}'", series_colour(k));
    if (round == 0) return "with lines " + line;
    const double every = std::max(1.0, static_cast<double>(curve.load.size()) / marks_a_curve);
    return fmt::format("with linespoints {} pt {} ps 0.8 pi {}", line, 4 + 2 * (round - 1) % 6,
                       static_cast<int>(every));
}

std::string curve_item(const LoadCurve& curve, std::size_t k, const std::string& title) {
    return fmt::format("'{}' using 1:2 {} {}", file_name(k), style(curve, k), title);
}

// Behind the curve: band and correction.
std::vector<std::string> bar_items(const LoadCurve& curve) {
    if (!has_bar(curve) || curve.load.empty()) return {};
    return {fmt::format(
                "'{}' using 1:4:5 with filledcurves fs solid noborder lc rgb '#d8e2ee' title '95 % interval'",
                file_name(0)),
            fmt::format(
                "'{}' using 1:3 with lines dt 3 lw 1.6 lc rgb '#444444' title 'corrected by the auditors'",
                file_name(0))};
}

// The picture's title names a single curve already.
std::string key_of(const LoadCurve& curve, const LoadPicture& picture) {
    if (picture.curves.size() == 1 || curve.label.empty()) return "notitle";
    const std::string words = curve.breakout.d_over_B > 0 ? ": " + breakout_words(curve) : "";
    return "title " + literal(curve.label + words);
}

std::string reference_item(const ReferenceLine& r) {
    return fmt::format("{} with lines dt 2 lw 1.5 lc rgb '#444444' notitle", r.n_gamma);
}

std::string keys_below(Plot& plot, const LoadPicture& picture) {
    const std::size_t curves = picture.curves.size();
    if (curves == 1 && has_bar(picture.curves[0])) return key_below(plot, 2);
    if (curves < 2) return "unset key\n";
    if (curves > few_curves) plot.width = 900;
    return key_below(plot, curves);
}

}  // namespace

Plot load_plot(const LoadPicture& picture) {
    Plot plot;
    const std::string keys = keys_below(plot, picture);
    const Extent e = extent_of(picture);
    plot.script = axes(picture, e, plot.width) + reference_labels(picture.references, e) + keys;
    std::string items;
    const auto add = [&](const std::string& item) {
        items += (items.empty() ? "plot " : ", \\\n     ") + item;
    };
    if (picture.curves.size() == 1)
        for (const std::string& item : bar_items(picture.curves.front())) add(item);
    for (std::size_t k = 0; k < picture.curves.size(); ++k) {
        plot.script += breakout_label(picture.curves[k], k, picture, e);
        plot.data.emplace_back(file_name(k), rows(picture.curves[k]));
        add(curve_item(picture.curves[k], k, key_of(picture.curves[k], picture)));
    }
    for (const ReferenceLine& r : picture.references) add(reference_item(r));
    plot.script += items + "\n";
    return plot;
}

Picture draw_load_picture(const LoadPicture& picture, const std::filesystem::path& png) {
    return draw(load_plot(picture), png);
}

}  // namespace sandgraph::report

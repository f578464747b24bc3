#include "report/breakout_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "report/colour_scale.hpp"
#include "results/analytic.hpp"

namespace sandgraph::report {
namespace {

constexpr int formula_points = 60;

double deepest(const std::vector<BreakoutSeries>& series) {
    double deep = 1;
    for (const BreakoutSeries& s : series)
        for (const double h : s.embedment) deep = std::max(deep, h);
    return deep;
}

double formula(const BreakoutSeries& s, double ratio) {
    return s.horizontal ? results::meyerhof_adams(ratio, s.friction_angle)
                        : results::biarez(ratio, s.friction_angle);
}

std::string formula_rows(const BreakoutSeries& s, double deep) {
    std::string text;
    for (int k = 0; k <= formula_points; ++k) {
        const double ratio = 1 + (deep - 1) * k / formula_points;
        text += fmt::format("{} {}\n", ratio, formula(s, ratio));
    }
    return text;
}

std::string measured_rows(const BreakoutSeries& s) {
    std::string text;
    for (std::size_t k = 0; k < s.embedment.size(); ++k)
        text += fmt::format("{} {}\n", s.embedment[k], s.n_gamma[k]);
    return text;
}

std::string formula_name(const BreakoutSeries& s) {
    return fmt::format("{}, phi = {:.1f} deg",
                       s.horizontal ? "Meyerhof & Adams (1968)" : "Biarez et al. (1965)",
                       s.friction_angle * 180 / std::numbers::pi);
}

}  // namespace

Plot breakout_plot(const std::vector<BreakoutSeries>& series) {
    const double deep = 1.1 * deepest(series);
    Plot plot;
    plot.width = 900;
    std::size_t keys = 0;
    for (const BreakoutSeries& s : series) keys += s.friction_angle > 0 ? 2 : 1;
    const std::string key = key_below(plot, keys);
    plot.script = fmt::format(
        "set xlabel 'embedment H/B'\nset ylabel 'breakout factor N_γ = Q_u/(BγH)'\nset xrange [0:{}]\nset "
        "yrange [0:*]\n"
        "set grid lt 1 lw 0.6 lc rgb '#e4e4e4'\n{}",
        deep, key);
    std::string items;
    const auto add = [&](const std::string& item) {
        items += (items.empty() ? "plot " : ", \\\n     ") + item;
    };
    for (std::size_t k = 0; k < series.size(); ++k) {
        const char* colour = series_colour(k);
        plot.data.emplace_back(fmt::format("measured{}.txt", k), measured_rows(series[k]));
        add(fmt::format("'measured{}.txt' with points pt 7 ps 1.6 lc rgb '{}' title {}", k, colour,
                        literal(series[k].label)));
        if (series[k].friction_angle <= 0) continue;
        plot.data.emplace_back(fmt::format("formula{}.txt", k), formula_rows(series[k], deep));
        add(fmt::format("'formula{}.txt' with lines dt 2 lw 1.5 lc rgb '{}' title {}", k, colour,
                        literal(formula_name(series[k]))));
    }
    plot.script += items + "\n";
    return plot;
}

Picture draw_breakout_picture(const std::vector<BreakoutSeries>& series, const std::filesystem::path& png) {
    return draw(breakout_plot(series), png);
}

}  // namespace sandgraph::report

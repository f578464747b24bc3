#include "report/sweep_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/statistics.hpp"
#include "report/colour_scale.hpp"

namespace sandgraph::report {
namespace {

using Curve = SweepPicture::Curve;
using Mark = SweepPicture::Mark;

constexpr const char* grid = "set grid lt 1 lw 0.6 lc rgb '#e4e4e4'\n";

std::string mark_rows(const Curve& curve) {
    std::string text;
    for (const Mark& m : curve.marks)
        if (std::isfinite(m.n_gamma))
            text += fmt::format("{} {} {}\n", m.at, m.n_gamma, std::isfinite(m.ci95) ? m.ci95 : 0);
    return text;
}

std::string formula_rows(const Curve& curve) {
    std::string text;
    for (const Mark& m : curve.marks)
        if (std::isfinite(m.formula)) text += fmt::format("{} {}\n", m.at, m.formula);
    return text;
}

// Room on both sides of the outermost marks.
std::string range_of(const SweepPicture& picture) {
    double low = INFINITY, high = -INFINITY;
    for (const Curve& curve : picture.curves)
        for (const Mark& m : curve.marks) low = std::min(low, m.at), high = std::max(high, m.at);
    const double room = high > low ? 0.08 * (high - low) : 0.5;
    return std::isfinite(low) ? fmt::format("set xrange [{}:{}]\n", low - room, high + room) : "";
}

std::string tics_of(const SweepPicture& picture) {
    if (picture.places.empty()) return "";
    std::string text = "set xtics (";
    for (std::size_t k = 0; k < picture.places.size(); ++k)
        text += fmt::format("{}{} {}", k == 0 ? "" : ", ", literal(picture.places[k]), k);
    return text + ") noenhanced\n";
}

// Curves and, where one knows it, its closed form; those without a mark are left out.
class Items {
  public:
    explicit Items(Plot& plot) : plot_(plot) {}
    void add(const Curve& curve, std::size_t k) {
        const char* colour = series_colour(k);
        const std::string name = fmt::format("curve{}.txt", k), closed = fmt::format("formula{}.txt", k);
        if (put(name, mark_rows(curve))) {
            item(fmt::format("'{}' with yerrorbars pt 0 lw 1.5 lc rgb '{}' notitle", name, colour));
            item(fmt::format("'{}' with linespoints pt 7 ps 1.3 lw 1.5 lc rgb '{}' title {}", name, colour,
                             literal(curve.label)));
        }
        if (put(closed, formula_rows(curve)))
            item(fmt::format("'{}' with linespoints dt 2 pt 0 lw 1.5 lc rgb '{}' title {}", closed, colour,
                             literal("closed form, " + curve.label)));
    }
    const std::string& text() const { return text_; }

  private:
    bool put(const std::string& name, const std::string& rows) {
        if (!rows.empty()) plot_.data.emplace_back(name, rows);
        return !rows.empty();
    }
    void item(const std::string& words) { text_ += (text_.empty() ? "plot " : ", \\\n     ") + words; }
    Plot& plot_;
    std::string text_;
};

// As wide as Freedman & Diaconis (1981) advise: 2 (q75 - q25)/n^(1/3); some where that is nothing.
double bin_width(const std::vector<double>& values) {
    const double spread = quantile(values, 0.75) - quantile(values, 0.25);
    const double width = 2 * spread / std::cbrt(static_cast<double>(values.size()));
    const auto [low, high] = std::ranges::minmax(values);
    const double least = high > low ? (high - low) / 100 : 1e-3 * std::max(1.0, std::fabs(high));
    return std::max(width, least);
}

std::string bins_of(const std::vector<double>& values, double width) {
    const auto [low, high] = std::ranges::minmax(values);
    std::vector<int> counts(static_cast<std::size_t>((high - low) / width) + 1, 0);
    for (const double value : values)
        ++counts[std::min(static_cast<std::size_t>((value - low) / width), counts.size() - 1)];
    std::string text;
    for (std::size_t k = 0; k < counts.size(); ++k)
        text += fmt::format("{} {}\n", low + (static_cast<double>(k) + 0.5) * width, counts[k]);
    return text;
}

}  // namespace

Plot sweep_plot(const SweepPicture& picture) {
    Plot plot;
    plot.width = 900;
    Items items(plot);
    for (std::size_t k = 0; k < picture.curves.size(); ++k) items.add(picture.curves[k], k);
    const std::string key = key_below(plot, std::max<std::size_t>(1, 2 * picture.curves.size()));
    plot.script = fmt::format(
        "set title {} noenhanced\nset xlabel {} noenhanced\nset ylabel 'breakout factor N_γ'\n{}{}{}{}set "
        "yrange [0:*]\n{}\n",
        wrapped(picture.title, plot.width), literal(picture.axis), grid, range_of(picture), tics_of(picture),
        key, items.text());
    return plot;
}

Plot histogram_plot(const HistogramPicture& picture) {
    Plot plot;
    const double width = bin_width(picture.values);
    plot.data.emplace_back("bins.txt", bins_of(picture.values, width));
    plot.script = fmt::format(
        "set title {} noenhanced\nset xlabel 'breakout factor N_γ'\nset ylabel 'samples'\n{}set yrange "
        "[0:*]\n"
        "set boxwidth {}\nset style fill solid 0.6\nset arrow from {},graph 0 to {},graph 1 nohead dt 2 lw "
        "1.5\n"
        "plot 'bins.txt' with boxes lc rgb '{}' notitle\n",
        wrapped(picture.title, plot.width), grid, width, sample_of(picture.values).mean,
        sample_of(picture.values).mean, series_colour(0));
    return plot;
}

}  // namespace sandgraph::report

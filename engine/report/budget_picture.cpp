#include "report/budget_picture.hpp"

#include <fmt/format.h>

#include <cmath>

#include "report/colour_scale.hpp"

namespace sandgraph::report {
namespace {

// Place, load after it, half of the interval, name.
std::string row(std::size_t place, double load, double ci95, const std::string& name) {
    return fmt::format("{} {} {} \"{}\"\n", place, load / 1e3, std::isfinite(ci95) ? ci95 / 1e3 : 0, name);
}

std::string rows_of(const results::Budget& b) {
    std::string text = row(0, b.load, 0, b.breakout ? "run" : "largest load");
    double load = b.load;
    for (std::size_t k = 0; k < b.items.size(); ++k) {
        load *= 1 + b.items[k].correction;
        text += row(k + 1, load, b.items[k].ci95 * load, b.items[k].source);
    }
    return text + row(b.items.size() + 1, b.corrected(), b.ci95(), "all");
}

}  // namespace

Plot budget_plot(const results::Budget& budget, const std::string& title) {
    Plot plot{720, 480, {}, {{"steps.txt", rows_of(budget)}}};
    plot.script = fmt::format(
        "set title {} noenhanced\nset ylabel 'breakout load [kN/m]'\nset xrange [-0.6:{}]\n"
        "set grid ytics lt 1 lw 0.6 lc rgb '#e4e4e4'\nset offsets 0, 0, graph 0.1, graph 0.1\n"
        "plot 'steps.txt' using 1:2:3:xtic(4) with yerrorbars pt 7 ps 1.4 lw 1.8 lc rgb '{}' notitle, "
        "'' using 1:2 with lines dt 2 lc rgb '#888888' notitle\n",
        wrapped(title, plot.width), static_cast<double>(budget.items.size()) + 1.6, series_colour(0));
    return plot;
}

Picture draw_budget_picture(const results::Budget& budget, const std::string& title,
                            const std::filesystem::path& png) {
    return draw(budget_plot(budget, title), png);
}

}  // namespace sandgraph::report

#include "report/pareto_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sandgraph::report {
namespace {

// gnuplot leaves out what is no number.
std::string number(double value) { return std::isfinite(value) ? fmt::format("{}", value) : "NaN"; }

// In data files only double quotes hold a text together.
std::string quoted(std::string text) {
    std::ranges::replace(text, '"', '\'');
    return '"' + text + '"';
}

std::string rows(const ParetoPicture& picture) {
    std::string out;
    for (const ParetoMark& m : picture.marks)
        out += fmt::format("{} {} {} {} {} {} {}\n", number(m.speedup), number(100 * m.peak_error),
                           number(100 * m.curve_error), number(100 * m.audit_mean),
                           number(100 * m.audit_ci95), number(100 * m.true_error), quoted(m.label));
    return out;
}

}  // namespace

Plot pareto_plot(const ParetoPicture& picture) {
    Plot plot{1500, 650, {}, {{"runs.txt", rows(picture)}}};
    plot.script = fmt::format(
        "set multiplot layout 1,2 title {} noenhanced\nset grid lt 1 lw 0.6 lc rgb '#e4e4e4'\n"
        "set xlabel 'times faster than full fidelity (wall clock)'\nset xrange [0:*]\nset yrange [0:*]\n"
        "set ylabel 'error of the load [% of the peak]'\nset key top left\n"
        "plot 'runs.txt' using 1:2 with points pt 7 ps 1.5 lc rgb '#0072B2' title 'peak', "
        "'' using 1:3 with points pt 5 ps 1.5 lc rgb '#D55E00' title 'curve (rms)', "
        "'' using 1:3:7 with labels offset 0,1.1 font ',9' noenhanced notitle\n"
        "set ylabel 'mean stress error of the surrogate points [% of p]'\n"
        "plot 'runs.txt' using 1:4:5 with yerrorbars pt 7 ps 1.2 lw 1.6 lc rgb '#009E73' "
        "title 'audit, 95 % interval', "
        "'' using 1:6 with points pt 2 ps 1.8 lw 2 lc rgb '#000000' title 'all points looked at', "
        "'' using 1:4:7 with labels offset 0,1.1 font ',9' noenhanced notitle\nunset multiplot\n",
        wrapped(picture.title, plot.width));
    return plot;
}

Picture draw_pareto_picture(const ParetoPicture& picture, const std::filesystem::path& png) {
    return draw(pareto_plot(picture), png);
}

}  // namespace sandgraph::report

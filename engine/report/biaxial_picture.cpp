#include "report/biaxial_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace sandgraph::report {
namespace {

// Okabe & Ito (2008), and the same at a quarter of their strength for single packings.
struct Colour {
    const char *full, *pale;
};
constexpr std::array<Colour, 3> colours{
    {{"#0072B2", "#B3D4E8"}, {"#D55E00", "#F4CFB3"}, {"#009E73", "#B3E2D5"}}};

BiaxialPoint point(const dem::BiaxialRow& row) {
    return {row.axial_strain, row.sin_phi, -row.volumetric_strain};
}

std::string text_row(const BiaxialPoint& p) {
    return fmt::format("{} {} {}\n", 100 * p.axial_strain, p.sin_phi, 100 * p.dilation);
}

// All packings of a series in one file, a blank line between two.
std::string single_tests(const BiaxialSeries& series) {
    std::string text;
    for (const auto& test : series.tests) {
        for (const dem::BiaxialRow& row : test) text += text_row(point(row));
        text += "\n";
    }
    return text;
}

std::string mean_rows(const BiaxialSeries& series) {
    std::string text;
    for (const BiaxialPoint& p : mean_test(series)) text += text_row(p);
    return text;
}

std::string mean_title(const BiaxialSeries& series) {
    return literal(
        fmt::format("{:g} kPa, mean of {}", series.confining_pressure / 1000, series.tests.size()));
}

// Pale lines first, so that the means lie on top.
std::string curves(const BiaxialPicture& picture, int column, bool titled) {
    std::string text = "plot ";
    for (std::size_t k = 0; k < picture.series.size(); ++k)
        text += fmt::format("'tests{}.txt' using 1:{} with lines lw 1 lc rgb '{}' notitle, \\\n", k, column,
                            colours[k % colours.size()].pale);
    for (std::size_t k = 0; k < picture.series.size(); ++k)
        text += fmt::format("{}'mean{}.txt' using 1:{} with lines lw 3 lc rgb '{}' {}", k ? ", \\\n" : "", k,
                            column, colours[k % colours.size()].full,
                            titled ? "title " + mean_title(picture.series[k]) : "notitle");
    return text + "\n";
}

std::string axes(const BiaxialPicture& picture) {
    return fmt::format(
        "set multiplot\nset grid lt 1 lw 0.6 lc rgb '#e4e4e4'\nset xrange [0:*]\nset autoscale xfixmax\nset "
        "xtics 0,5\n"
        "set lmargin at screen 0.1\nset rmargin at screen 0.97\nset title {} noenhanced\n",
        literal(picture.title));
}

}  // namespace

std::vector<BiaxialPoint> mean_test(const BiaxialSeries& series) {
    if (series.tests.empty()) return {};
    const auto shortest = std::ranges::min_element(series.tests, {}, [](const auto& t) { return t.size(); });
    std::vector<BiaxialPoint> mean(shortest->size());
    const double n = static_cast<double>(series.tests.size());
    for (const auto& test : series.tests)
        for (std::size_t k = 0; k < mean.size(); ++k) {
            const BiaxialPoint p = point(test[k]);
            mean[k].axial_strain += p.axial_strain / n;
            mean[k].sin_phi += p.sin_phi / n, mean[k].dilation += p.dilation / n;
        }
    return mean;
}

Plot biaxial_plot(const BiaxialPicture& picture) {
    Plot plot;
    plot.width = 1000, plot.height = 1000;
    for (std::size_t k = 0; k < picture.series.size(); ++k) {
        plot.data.emplace_back(fmt::format("tests{}.txt", k), single_tests(picture.series[k]));
        plot.data.emplace_back(fmt::format("mean{}.txt", k), mean_rows(picture.series[k]));
    }
    plot.script =
        axes(picture) +
        "set tmargin at screen 0.95\nset bmargin at screen 0.52\nset format x ''\n"
        "set ylabel 'mobilised friction q/p = sin φ' offset 1\nset yrange [0:*]\n"
        "set key bottom right noenhanced\n" +
        curves(picture, 2, true) +
        "unset title\nset tmargin at screen 0.49\nset bmargin at screen 0.07\nset format x '%g'\n"
        "set ylabel 'dilation −ε_v [%]' offset 1\nset yrange [*:*]\nset xlabel 'axial strain ε_a [%]'\n"
        "set xzeroaxis lt 1 lw 1 lc rgb '#888888'\nunset key\n" +
        curves(picture, 3, false) + "unset multiplot\n";
    return plot;
}

Picture draw_biaxial_picture(const BiaxialPicture& picture, const std::filesystem::path& png) {
    return draw(biaxial_plot(picture), png);
}

}  // namespace sandgraph::report

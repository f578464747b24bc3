#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/csv.hpp"
#include "report/colour_scale.hpp"
#include "report/region_picture.hpp"

namespace sandgraph::report {
namespace {

// One line a moment: p [kPa], q [kPa], e.
std::string path_rows(const io::RegionSeries& region) {
    std::string text;
    for (const io::RegionRow& row : region.rows)
        text += fmt::format("{:.6g} {:.6g} {:.6g}\n", row.p.mean / 1e3, row.q.mean / 1e3,
                            row.porosity.mean / (1 - row.porosity.mean));
    return text;
}

std::string paths(const RegionPicture& picture, int column, bool titled) {
    std::string text;
    for (std::size_t r = 0; r < picture.regions.size(); ++r)
        text += fmt::format(
            "'path{0}.txt' using 1:{1} with lines lw 1.6 lc rgb '{2}' {3}, 'end{0}.txt' using 1:{1} with "
            "points "
            "pt 7 ps 2 lc rgb '{2}' notitle, ",
            r, column, series_colour(r), titled ? "title " + literal(picture.regions[r].name) : "notitle");
    return text.substr(0, text.size() - 2);
}

std::string critical_item(const std::string& formula, const char* title) {
    return fmt::format(", {} with lines dt 2 lw 2 lc rgb '#444444' title '{}'", formula, title);
}

constexpr const char* how_to_make_one = "make one: sandgraph rve critical -o DIR writes critical_state.csv";

// The columns of critical_state.csv that are read here.
struct CriticalColumns {
    std::size_t pressure, q_over_p, void_ratio;
};

std::size_t column(const CsvReader& in, std::string_view name) {
    const auto cells = in.cells();
    const auto found = std::ranges::find(cells, name);
    if (found == cells.end())
        in.refuse("not a critical state table", fmt::format("its first line names no column {}", name),
                  how_to_make_one);
    return static_cast<std::size_t>(found - cells.begin());
}

// p/100 kPa, q/p and e of one test.
std::array<double, 3> read_test(const CsvReader& in, const CriticalColumns& at) {
    const auto cells = in.cells();
    if (cells.size() <= std::max({at.pressure, at.q_over_p, at.void_ratio}))
        in.refuse(fmt::format("{} columns", cells.size()), "fewer than the first line names",
                  how_to_make_one);
    const double pressure = in.number(cells[at.pressure]);
    if (!(pressure > 0))
        in.refuse(fmt::format("pressure {} Pa", pressure), "it must be positive", how_to_make_one);
    return {pressure / 100e3, in.number(cells[at.q_over_p]), in.number(cells[at.void_ratio])};
}

}  // namespace

CriticalLines read_critical_lines(const std::filesystem::path& csv) {
    CsvReader in(csv);
    in.next_row();
    const CriticalColumns at{column(in, "pressure"), column(in, "q_over_p"), column(in, "void_ratio")};
    double n = 0, ratio = 0, x = 0, e = 0, xx = 0, xe = 0;
    while (in.next_row()) {
        const auto [p, q_over_p, void_ratio] = read_test(in, at);
        n += 1, ratio += q_over_p, x += p, e += void_ratio, xx += p * p, xe += p * void_ratio;
    }
    if (!(n * xx - x * x > 1e-9))
        throw InputError({csv.string()}, "not a critical state table",
                         "it needs tests at two pressures or more", how_to_make_one);
    const double slope = (n * xe - x * e) / (n * xx - x * x);
    return {ratio / n, (e - slope * x) / n, -slope};
}

Plot stress_path_plot(const RegionPicture& picture, const std::optional<CriticalLines>& lines) {
    Plot plot;
    plot.width = 1300, plot.height = 600;
    for (std::size_t r = 0; r < picture.regions.size(); ++r) {
        io::RegionSeries end{"", 0, {}};
        if (!picture.regions[r].rows.empty()) end.rows = {picture.regions[r].rows.back()};
        plot.data.emplace_back(fmt::format("path{}.txt", r), path_rows(picture.regions[r]));
        plot.data.emplace_back(fmt::format("end{}.txt", r), path_rows(end));
    }
    plot.script = fmt::format(
        "set multiplot layout 1,2 title {} noenhanced\nset grid lt 1 lw 0.6 lc rgb '#e4e4e4'\nset xlabel "
        "'mean "
        "stress p [kPa]'\nset ylabel 'deviator q [kPa]'\nset key top left noenhanced\nset yrange [0:*]\nset "
        "xrange "
        "[0:*]\nplot {}{}\n",
        wrapped(picture.title + ": stress paths of the regions (dot: end)", plot.width),
        paths(picture, 2, true),
        lines ? critical_item(fmt::format("{} * x", lines->stress_ratio), "critical state") : "");
    plot.script += fmt::format(
        "set ylabel 'void ratio e'\nset yrange [*:*]\nset xrange [0.3:*]\nset logscale x\nset key bottom "
        "left\nplot {}{}\nunset multiplot\n",
        paths(picture, 3, false),
        lines ? critical_item(fmt::format("{} - {} * x / 100", lines->e_0, lines->slope), "critical state")
              : "");
    return plot;
}

Picture draw_stress_path_picture(const RegionPicture& picture, const std::optional<CriticalLines>& lines,
                                 const std::filesystem::path& png) {
    return draw(stress_path_plot(picture, lines), png);
}

}  // namespace sandgraph::report

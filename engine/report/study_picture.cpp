#include "report/study_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace sandgraph::report {
namespace {

StudyMark mark(const laboratory::StudyRow& r) { return {r.dem_steps, r.error.rms}; }

// One curve a varied key. The default lies on all of them.
std::vector<StudyCurve> curves(const std::vector<laboratory::StudyRow>& panel) {
    std::vector<StudyCurve> out;
    for (std::size_t k = laboratory::study_default + 1; k < panel.size(); ++k) {
        if (out.empty() || out.back().label != panel[k].setting.key)
            out.push_back({panel[k].setting.key, {mark(panel[laboratory::study_default])}});
        out.back().marks.push_back(mark(panel[k]));
    }
    for (StudyCurve& curve : out)
        std::sort(curve.marks.begin(), curve.marks.end(),
                  [](const auto& a, const auto& b) { return a.dem_steps < b.dem_steps; });
    return out;
}

StudyPanel panel_of(const std::vector<laboratory::StudyRow>& panel) {
    const laboratory::StudyRow& first = panel.front();
    const bool means = first.history.window != 0;
    return {first.history.name + (means ? " (window means)" : ""),
            curves(panel),
            mark(panel[laboratory::study_default]),
            mark(panel[laboratory::study_peers]),
            panel[laboratory::study_twin].error.rms,
            first.error.scatter};
}

}  // namespace

StudyPicture study_picture(const std::vector<laboratory::StudyRow>& rows, int seeds) {
    StudyPicture picture{"Stress error of an RVE against its DEM steps, seeds: " + std::to_string(seeds), {}};
    for (auto begin = rows.begin(); begin != rows.end();) {
        const auto end = std::find_if(begin, rows.end(), [&](const laboratory::StudyRow& r) {
            return r.history.name != begin->history.name;
        });
        picture.panels.push_back(panel_of({begin, end}));
        begin = end;
    }
    return picture;
}

namespace {

// Okabe & Ito (2008): distinguishable with colour-vision deficiency.
constexpr std::array<const char*, 7> colours{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                             "#E69F00", "#56B4E9", "#8B4513"};
constexpr std::size_t columns = 3;
// What a logarithmic axis can still show: no DEM step at all, no error at all.
constexpr double least_steps = 1, least_error = 1e-6;

std::string point(const StudyMark& m) {
    return fmt::format("{} {}\n", std::max(m.dem_steps, least_steps), std::max(m.error, least_error));
}

std::string file_name(std::size_t panel, const std::string& what) {
    return fmt::format("panel{}_{}.txt", panel, what);
}

// A level with its entry in the key, which is that of the first panel, also where it cannot be drawn.
std::string level(double error, const char* dash, const char* label) {
    const std::string style = fmt::format("with lines dt {} lw 1.5 lc rgb '#777777'", dash);
    const std::string line = error > 0 ? fmt::format(", {} {} notitle", error, style) : std::string();
    return fmt::format("{}, keyentry {} title '{}'", line, style, label);
}

std::string mark_item(const std::string& file, int point_type, const char* colour, const char* label) {
    return fmt::format(", '{}' with points pt {} ps 2 lw 2 lc rgb '{}' title '{}'", file, point_type, colour,
                       label);
}

void add_panel(Plot& plot, const StudyPanel& panel, std::size_t k) {
    std::string items;
    for (std::size_t c = 0; c < panel.curves.size(); ++c) {
        std::string rows;
        for (const StudyMark& m : panel.curves[c].marks) rows += point(m);
        const std::string file = file_name(k, std::to_string(c));
        plot.data.emplace_back(file, rows);
        items += fmt::format("{}'{}' with linespoints pt 7 ps 0.7 lw 1.8 lc rgb '{}' title {} noenhanced",
                             items.empty() ? "plot " : ", ", file, colours[c % colours.size()],
                             literal(panel.curves[c].label));
    }
    plot.data.emplace_back(file_name(k, "default"), point(panel.standard));
    plot.data.emplace_back(file_name(k, "peers"), point(panel.peers));
    items += mark_item(file_name(k, "default"), 3, "#000000", "default") +
             mark_item(file_name(k, "peers"), 4, "#000000", "2 steps or more each load step");
    items += ", 0.01 with lines dt 3 lw 1 lc rgb '#bbbbbb' title '1 % of p'";
    items += level(panel.floor, "2", "two fine answers") + level(panel.scatter, "4", "seed to seed");
    plot.script += fmt::format("set ylabel '{}'\nset title {} noenhanced\n{}\n",
                               k % columns == 0 ? "rms stress error / p" : "", literal(panel.title), items);
    plot.script += "unset key\n";  // one key for all panels
}

}  // namespace

Plot study_plot(const StudyPicture& picture) {
    const std::size_t rows = (picture.panels.size() + columns - 1) / columns;
    Plot plot{1500, static_cast<int>(120 + 450 * rows), {}, {}};
    plot.script = fmt::format(
        "set multiplot layout {},{} title {} noenhanced margins 0.075,0.985,0.22,0.92 spacing 0.05,0.11\n"
        "set logscale xy\nset format x '10^{{%L}}'\nset format y '%g'\nset xlabel 'DEM steps'\n"
        "set grid lt 1 lw 0.6 lc rgb '#e4e4e4'\n"
        "set key at screen 0.5,0.065 center center vertical maxrows 4 width 1 samplen 2\n",
        rows, columns, literal(picture.title));
    for (std::size_t k = 0; k < picture.panels.size(); ++k) add_panel(plot, picture.panels[k], k);
    plot.script += "unset multiplot\n";
    return plot;
}

Picture draw_study_picture(const StudyPicture& picture, const std::filesystem::path& png) {
    return draw(study_plot(picture), png);
}

}  // namespace sandgraph::report

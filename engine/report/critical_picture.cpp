#include "report/critical_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace sandgraph::report {
namespace {

// Okabe & Ito (2008), and the same at a quarter of their strength for single tests.
struct Style {
    const char *density, *full, *pale;
};
constexpr std::array<Style, 2> styles{{{"dense", "#0072B2", "#B3D4E8"}, {"loose", "#D55E00", "#F4CFB3"}}};

struct Panel {
    const char* label;
    int column;
};
constexpr std::array<Panel, 3> panels{{{"q/p", 2}, {"porosity n", 3}, {"fabric anisotropy F_a", 4}}};

std::string row_text(double strain, double ratio, double porosity, double anisotropy) {
    return fmt::format("{} {} {} {}\n", 100 * strain, ratio, porosity, anisotropy);
}

std::vector<const CriticalCurve*> of_density(const CriticalPicture& picture, std::string_view density) {
    std::vector<const CriticalCurve*> chosen;
    for (const CriticalCurve& curve : picture.curves)
        if (curve.density == density) chosen.push_back(&curve);
    return chosen;
}

// The first row lies at strain 0, which a logarithmic axis cannot show.
std::string single_rows(const std::vector<const CriticalCurve*>& curves) {
    std::string text;
    for (const CriticalCurve* curve : curves) {
        for (std::size_t k = 1; k < curve->rows.size(); ++k) {
            const dem::ShearRow& row = curve->rows[k];
            text += row_text(row.shear_strain, row.stress_ratio, row.seen.porosity, row.seen.anisotropy);
        }
        text += "\n";
    }
    return text;
}

std::string mean_rows(const std::vector<const CriticalCurve*>& curves) {
    std::size_t rows = curves.empty() ? 0 : curves.front()->rows.size();
    for (const CriticalCurve* curve : curves) rows = std::min(rows, curve->rows.size());
    std::string text;
    for (std::size_t k = 1; k < rows; ++k) {
        double strain = 0, ratio = 0, porosity = 0, anisotropy = 0;
        for (const CriticalCurve* curve : curves) {
            const dem::ShearRow& row = curve->rows[k];
            strain += row.shear_strain, ratio += row.stress_ratio;
            porosity += row.seen.porosity, anisotropy += row.seen.anisotropy;
        }
        const double n = static_cast<double>(curves.size());
        text += row_text(strain / n, ratio / n, porosity / n, anisotropy / n);
    }
    return text;
}

std::string late_rows(const std::vector<const CriticalCurve*>& curves) {
    std::string text;
    for (const CriticalCurve* curve : curves)
        text += fmt::format("{} {}\n", curve->pressure / 1e3, curve->void_ratio);
    return text;
}

std::string curves_of(const Panel& panel) {
    std::string text = fmt::format("set ylabel '{}' noenhanced\nplot ", panel.label);
    for (const Style& s : styles)
        text += fmt::format("'tests_{}.txt' using 1:{} with lines lw 1 lc rgb '{}' notitle, \\\n", s.density,
                            panel.column, s.pale);
    for (const Style& s : styles)
        text += fmt::format("{}'mean_{}.txt' using 1:{} with lines lw 3 lc rgb '{}' title '{}'",
                            &s == &styles.front() ? "" : ", ", s.density, panel.column, s.full, s.density);
    return text + "\nunset key\n";  // one key for all panels
}

std::string late_panel(const CriticalPicture& picture) {
    std::string text = "set xlabel 'mean stress p [kPa]'\nset ylabel 'late void ratio e'\nplot ";
    for (const Style& s : styles)
        text += fmt::format("{}'late_{}.txt' with points pt 7 ps 1 lc rgb '{}'",
                            &s == &styles.front() ? "" : ", ", s.density, s.full);
    if (picture.line)
        text += fmt::format(", {} - {} * x / 100 with lines lw 2 lc rgb '#444444'", picture.line->e_0,
                            picture.line->slope);
    return text + "\n";
}

}  // namespace

Plot critical_plot(const CriticalPicture& picture) {
    Plot plot;
    plot.width = 1300, plot.height = 950;
    for (const Style& s : styles) {
        const auto curves = of_density(picture, s.density);
        plot.data.emplace_back(fmt::format("tests_{}.txt", s.density), single_rows(curves));
        plot.data.emplace_back(fmt::format("mean_{}.txt", s.density), mean_rows(curves));
        plot.data.emplace_back(fmt::format("late_{}.txt", s.density), late_rows(curves));
    }
    plot.script =
        "set multiplot layout 2,2 title 'Shear at constant mean stress: dense and loose sand meet'\n"
        "set grid lt 1 lw 0.6 lc rgb '#e4e4e4'\nset logscale x\nset autoscale xfix\nset xlabel 'shear strain "
        "γ [%]'\n"
        "set key bottom right\n";
    for (const Panel& panel : panels) plot.script += curves_of(panel);
    plot.script += late_panel(picture) + "unset multiplot\n";
    return plot;
}

Picture draw_critical_picture(const CriticalPicture& picture, const std::filesystem::path& png) {
    return draw(critical_plot(picture), png);
}

}  // namespace sandgraph::report

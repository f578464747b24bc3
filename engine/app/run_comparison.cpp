#include <fmt/format.h>

#include <cmath>
#include <map>
#include <numbers>

#include "app/run_pictures.hpp"
#include "app/run_report.hpp"
#include "report/breakout_picture.hpp"
#include "report/html.hpp"

namespace sandgraph::app {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

std::string series_of(const FinishedRun& run) {
    return fmt::format(
        "{}, {}{}", pulled_up(run.scene) ? "horizontal" : "vertical",
        run.scene.ground.law == scene::Law::rve ? run.scene.ground.grains.density : "continuum",
        run.summary.mode == "screening" ? ", screening" : "");
}

std::string text(double value, int digits) {
    return std::isfinite(value) ? fmt::format("{:.{}g}", value, digits) : "-";
}

// H/B; under a surcharge that of the same overburden.
report::Row row_of(const FinishedRun& run) {
    const io::Summary& s = run.summary;
    const double formula = pulled_up(run.scene) ? s.n_gamma_meyerhof_adams : s.n_gamma_biarez;
    return {run.folder.string(),        series_of(run),
            text(embedment_of(run), 3), text(s.n_gamma, 3),
            text(formula, 3),           fmt::format("{:+.1f} %", 100 * (s.n_gamma / formula - 1)),
            text(s.peak_d_over_B, 2),   text(s.late_load / 1000, 3),
            text(s.wall_s, 3)};
}

std::vector<report::BreakoutSeries> series(const std::vector<FinishedRun>& runs) {
    std::map<std::string, report::BreakoutSeries> found;
    for (const FinishedRun& run : runs) {
        report::BreakoutSeries& s = found[series_of(run)];
        s.label = series_of(run), s.horizontal = pulled_up(run.scene);
        const double phi = run.summary.number("friction_angle_deg") * kDegree;
        if (std::isfinite(phi)) s.friction_angle += phi;
        s.embedment.push_back(embedment_of(run)), s.n_gamma.push_back(run.summary.n_gamma);
    }
    std::vector<report::BreakoutSeries> out;
    for (auto& [label, s] : found) {
        s.friction_angle /= static_cast<double>(s.embedment.size());
        out.push_back(std::move(s));
    }
    return out;
}

report::LoadPicture load_picture(const std::vector<FinishedRun>& runs, bool up) {
    report::LoadPicture picture{up ? "Horizontal plates" : "Vertical plates", {}, {}};
    for (const FinishedRun& run : runs) {
        if (pulled_up(run.scene) != up) continue;
        const double unit = run.summary.number("unit_load_N_per_m");
        picture.curves.push_back(
            load_curve({run.scene, run.record, run.frame_file(), std::isfinite(unit) ? unit : 1, 0}));
        picture.curves.back().label = fmt::format("{}, H/B = {:.3g} ({})", series_of(run), embedment_of(run),
                                                  run.folder.filename().string());
    }
    return picture;
}

}  // namespace

std::string comparison_chapter(const std::vector<FinishedRun>& runs, const std::filesystem::path& pictures) {
    std::vector<report::Row> rows = {{"run", "anchor, sand", "H/B", "N_gamma", "formula", "difference",
                                      "at d/B", "late load [kN/m]", "wall time [s]"}};
    for (const FinishedRun& run : runs) rows.push_back(row_of(run));
    std::string html = report::table(rows);
    std::filesystem::create_directories(pictures);
    report::draw_breakout_picture(series(runs), pictures / "breakout.png");
    for (const bool up : {true, false}) {
        const report::LoadPicture loads = load_picture(runs, up);
        const std::filesystem::path png = pictures / (up ? "loads_horizontal.png" : "loads_vertical.png");
        if (loads.curves.empty()) continue;
        report::draw_load_picture(loads, png);
        html += report::figure(png, "Load curves: " + loads.title);
    }
    html += report::figure(pictures / "breakout.png",
                           "Breakout factor against embedment, with the closed forms at "
                           "the friction angle measured on the packings");
    return html;
}

}  // namespace sandgraph::app

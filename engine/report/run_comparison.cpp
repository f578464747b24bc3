#include <fmt/format.h>

#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "report/html.hpp"
#include "report/run_pictures.hpp"
#include "report/run_report.hpp"
#include "results/run_summary.hpp"

namespace sandgraph::report {
namespace {

namespace fs = std::filesystem;

constexpr double kDegree = std::numbers::pi / 180;

std::string series_of(const results::FinishedRun& run) {
    return fmt::format(
        "{}, {}{}", results::pulled_up(run.scene) ? "horizontal" : "vertical",
        run.scene.ground.law == scene::Law::rve ? run.scene.ground.grains.density : "continuum",
        run.summary.mode == "screening" ? ", screening" : "");
}

std::string text(double value, int digits) {
    return std::isfinite(value) ? fmt::format("{:.{}g}", value, digits) : "-";
}

// H/B; under a surcharge that of the same overburden.
report::Row row_of(const results::FinishedRun& run) {
    const io::Summary& s = run.summary;
    const double formula = results::pulled_up(run.scene) ? s.n_gamma_meyerhof_adams : s.n_gamma_biarez;
    // The largest load of a curve that still rises tells nothing of the formula.
    const double difference = results::broke_out(s) ? 100 * (s.n_gamma / formula - 1) : std::nan("");
    return {run.folder.string(),
            series_of(run),
            text(results::embedment_of(run), 3),
            text(s.n_gamma, 3) + (results::broke_out(s) ? "" : " (still rising)"),
            text(formula, 3),
            std::isfinite(difference) ? fmt::format("{:+.1f} %", difference) : "-",
            text(s.breakout_d_over_B, 2),
            text(s.late_load / 1000, 3),
            text(s.wall_s, 3)};
}

double mean(const std::vector<double>& values) {
    return values.empty() ? 0 : std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

report::LoadPicture load_picture(const std::vector<results::FinishedRun>& runs, bool up) {
    report::LoadPicture picture{up ? "Horizontal plates" : "Vertical plates", {}, {}};
    for (const results::FinishedRun& run : runs) {
        if (results::pulled_up(run.scene) != up) continue;
        picture.curves.push_back(load_curve(run));
        picture.curves.back().label = fmt::format("{}, H/B = {:.3g} ({})", series_of(run),
                                                  results::embedment_of(run), run.folder.filename().string());
    }
    return picture;
}

}  // namespace

std::vector<report::BreakoutSeries> breakout_series(const std::vector<results::FinishedRun>& runs) {
    std::map<std::string, std::pair<report::BreakoutSeries, std::vector<double>>> found;  // angles
    for (const results::FinishedRun& run : runs) {
        if (!results::broke_out(run.summary) || !std::isfinite(run.summary.n_gamma)) continue;
        auto& [s, angles] = found[series_of(run)];
        s.label = series_of(run), s.horizontal = results::pulled_up(run.scene);
        const double phi = run.summary.number("friction_angle_deg") * kDegree;
        if (std::isfinite(phi)) angles.push_back(phi);
        s.embedment.push_back(results::embedment_of(run)), s.n_gamma.push_back(run.summary.n_gamma);
    }
    std::vector<report::BreakoutSeries> out;
    for (auto& [label, of] : found) {
        of.first.friction_angle = mean(of.second);
        out.push_back(std::move(of.first));
    }
    return out;
}

namespace {

// An older report's picture goes first: it would pass for this one's if none can be drawn.
std::string load_figure(const std::vector<results::FinishedRun>& runs, bool up, const fs::path& png) {
    fs::remove(png);
    const report::LoadPicture loads = load_picture(runs, up);
    if (loads.curves.empty()) return "";
    report::draw_load_picture(loads, png);
    return report::figure(png, "Load curves: " + loads.title);
}

std::string breakout_figure(const std::vector<results::FinishedRun>& runs, const fs::path& png) {
    fs::remove(png);
    const std::vector<report::BreakoutSeries> series = breakout_series(runs);
    if (series.empty()) return "<p>No run has broken out yet.</p>\n";
    report::draw_breakout_picture(series, png);
    return report::figure(png,
                          "Breakout factor against embedment of the runs that broke out, with the closed "
                          "forms at the friction angle measured on the packings");
}

}  // namespace

std::string comparison_chapter(const std::vector<results::FinishedRun>& runs, const fs::path& pictures) {
    std::vector<report::Row> rows = {{"run", "anchor, sand", "H/B", "N_gamma", "formula", "difference",
                                      "at d/B", "late load [kN/m]", "wall time [s]"}};
    for (const results::FinishedRun& run : runs) rows.push_back(row_of(run));
    fs::create_directories(pictures);
    return report::table(rows) + load_figure(runs, true, pictures / "loads_horizontal.png") +
           load_figure(runs, false, pictures / "loads_vertical.png") +
           breakout_figure(runs, pictures / "breakout.png");
}

}  // namespace sandgraph::report

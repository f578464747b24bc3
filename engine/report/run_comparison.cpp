#include <fmt/format.h>

#include <algorithm>
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

std::string decimal(double value, int decimals) {
    return std::isfinite(value) ? fmt::format("{:.{}f}", value, decimals) : "-";
}

struct Column {
    const char* name;
    std::string (*cell)(const results::FinishedRun& run);
    bool of_screening = false;  // only where there is a screening run
};

double formula_of(const results::FinishedRun& run) {
    return results::pulled_up(run.scene) ? run.summary.n_gamma_meyerhof_adams : run.summary.n_gamma_biarez;
}

// The largest load of a curve that still rises tells nothing of the formula.
std::string difference(const results::FinishedRun& run) {
    const double share = run.summary.n_gamma / formula_of(run) - 1;
    return run.summary.breakout && std::isfinite(share) ? fmt::format("{:+.1f} %", 100 * share) : "-";
}

std::string friction(const results::FinishedRun& run) {
    const double interval = run.summary.number("friction_angle_ci95_deg");
    return decimal(run.summary.number("friction_angle_deg"), 1) +
           (interval > 0 ? fmt::format(" ± {:.1f}", interval) : "");
}

std::string no_breakout(const results::FinishedRun& run) {
    return run.summary.breakout ? "" : " (no breakout)";
}

using Run = results::FinishedRun;

// H/B: under a surcharge that of the same overburden.
constexpr Column kColumns[] = {
    {"run", [](const Run& r) { return r.folder.string(); }},
    {"anchor, sand", [](const Run& r) { return series_of(r); }},
    {"H/B", [](const Run& r) { return text(results::embedment_of(r), 3); }},
    {"γ [kN/m3]", [](const Run& r) { return decimal(results::unit_weight(r) / 1000, 1); }},
    {"φ [deg]", friction},
    {"breakout load [kN/m]",
     [](const Run& r) { return decimal(r.summary.breakout_load / 1000, 1) + no_breakout(r); }},
    {"N_gamma", [](const Run& r) { return decimal(r.summary.n_gamma, 2); }},
    {"at d/B", [](const Run& r) { return decimal(r.summary.breakout_d_over_B, 3); }},
    {"formula", [](const Run& r) { return decimal(formula_of(r), 2); }},
    {"difference", difference},
    {"late load [kN/m]", [](const Run& r) { return decimal(r.summary.late_load / 1000, 1); }},
    {"gate", [](const Run& r) { return gate_text(r.scene); }, true},
    {"audit, share of p", [](const Run& r) { return audit_text(r.summary); }, true},
    {"wall time [s]", [](const Run& r) { return text(r.summary.wall_s, 3); }}};

std::string table_of(const std::vector<results::FinishedRun>& runs) {
    const bool screening =
        std::ranges::any_of(runs, [](const Run& run) { return run.summary.mode == "screening"; });
    std::vector<report::Row> rows(1 + runs.size());
    std::vector<std::string> links{""};
    for (const Run& run : runs) links.push_back(link_to(run.folder.string()));
    for (const Column& column : kColumns) {
        if (column.of_screening && !screening) continue;
        rows[0].emplace_back(column.name);
        for (std::size_t k = 0; k < runs.size(); ++k) rows[k + 1].push_back(column.cell(runs[k]));
    }
    return report::table(rows, true, links);
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
        if (!run.summary.breakout || !std::isfinite(run.summary.n_gamma)) continue;
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

std::string gate_text(const scene::Scene& scene) {
    if (scene.mode != scene::Mode::screening) return "-";
    const graph::GateSettings& gate = scene.screening.gate;
    return gate.active ? fmt::format("strain {:g}, flow {:g}", gate.strain, gate.flow) : "off";
}

std::string audit_text(const io::Summary& s) {
    if (s.audit.points == 0 || !std::isfinite(s.audit.stress_error_mean)) return "-";
    return fmt::format("{:.1f} %", 100 * s.audit.stress_error_mean) +
           (std::isfinite(s.audit.ci95) ? fmt::format(" ± {:.1f} %", 100 * s.audit.ci95) : "");
}

std::string comparison_chapter(const std::vector<results::FinishedRun>& runs, const fs::path& pictures) {
    fs::create_directories(pictures);
    return table_of(runs) + load_figure(runs, true, pictures / "loads_horizontal.png") +
           load_figure(runs, false, pictures / "loads_vertical.png") +
           breakout_figure(runs, pictures / "breakout.png");
}

}  // namespace sandgraph::report

#include "report/run_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "base/error.hpp"
#include "base/text.hpp"
#include "io/packing_file.hpp"
#include "report/html.hpp"
#include "report/packing_picture.hpp"
#include "report/run_pictures.hpp"
#include "results/failure_table.hpp"
#include "results/ground_view.hpp"
#include "results/run_summary.hpp"

namespace sandgraph::report {
namespace {

namespace fs = std::filesystem;
using report::Row;

// packings/NAME_DDDD.h5
struct KeptPacking {
    fs::path file;
    std::string region;
    double d_over_B = 0;
};

std::vector<KeptPacking> kept_packings(const fs::path& folder) {
    std::vector<KeptPacking> found;
    if (!fs::is_directory(folder)) return found;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string stem = entry.path().stem().string();
        const std::size_t mark = stem.rfind('_');
        if (entry.path().extension() != ".h5" || mark == std::string::npos) continue;
        found.push_back(
            {entry.path(), stem.substr(0, mark), std::strtod(stem.c_str() + mark + 1, nullptr) / 1e3});
    }
    std::ranges::sort(found, {}, [](const KeptPacking& k) { return std::tie(k.region, k.d_over_B); });
    return found;
}

std::string packing_figures(const results::FinishedRun& run, const fs::path& pictures) {
    std::string html;
    std::optional<report::PackingPicture::FirstCell> first;
    std::string region;
    for (const KeptPacking& kept : kept_packings(run.folder / "packings")) {
        const io::PackingRecord record = io::read_packing(kept.file);
        if (kept.region != region) first = {record.packing.H, kept.d_over_B}, region = kept.region;
        const std::string caption = fmt::format("packing of {}, d/B = {:.3g}", kept.region, kept.d_over_B);
        const fs::path png = pictures / (kept.file.stem().string() + ".png");
        report::draw_packing_picture(
            {results::title_of(run.scene) + ": " + caption, record.packing, record.material, first}, png);
        html += report::figure(png, caption);
    }
    return html.empty() ? html : "<h3>Packings</h3>\n<div class=\"grid\">\n" + html + "</div>\n";
}

std::string region_figures(const results::FinishedRun& run, const fs::path& pictures,
                           const std::optional<report::CriticalLines>& critical) {
    if (run.record.regions.empty()) return "";
    const report::RegionPicture picture{results::title_of(run.scene), run.record.regions,
                                        !run.scene.anchor.present};
    report::draw_region_picture(picture, pictures / "regions.png");
    report::draw_stress_path_picture(picture, critical, pictures / "stress_paths.png");
    return "<h3>Regions</h3>\n" +
           report::figure(pictures / "regions.png", "What the regions show: mean (line) and range (shadow)") +
           report::figure(pictures / "stress_paths.png", "Stress paths of the regions' means");
}

std::string text(double value, int digits = 3) {
    return std::isfinite(value) ? fmt::format("{:.{}g}", value, digits) : "-";
}

Row failure_row(const results::FailureRow& r, bool up) {
    Row row = {text(r.d_over_B), text(r.surface.highest), text(r.surface.heave_ahead)};
    if (up)
        row.insert(row.end(), {text(r.cavity, 2), text(r.zone.ahead), text(r.zone.above), text(r.total.lower),
                               text(r.total.middle), text(r.total.upper)});
    else
        row.insert(row.end(), {text(r.surface.lowest), text(r.surface.sink_behind), text(r.zone.ahead),
                               text(r.zone.behind), text(r.zone.above)});
    return row;
}

std::string failure_pattern(const results::FinishedRun& run) {
    const bool up = results::pulled_up(run.scene);
    std::vector<Row> rows = {{"d/B", "highest rise / d", "heave to [B]"}};
    for (const char* name :
         up ? std::vector{"cavity open", "strained to [B]", "above [B]", "band lower [deg]", "middle [deg]",
                          "upper [deg]"}
            : std::vector{"lowest / d", "sink to [B]", "strained ahead [B]", "behind [B]", "above [B]"})
        rows[0].emplace_back(name);
    for (const results::FailureRow& row : results::failure_rows(run)) rows.push_back(failure_row(row, up));
    if (rows.size() < 2) return "";
    return report::details(
        "Failure pattern, frame by frame (heave: rise above d/10; strained: eps_eq above 0.1; band: by "
        "thirds of its "
        "height, angle to the horizontal)",
        report::table(rows));
}

// What a run tells across the scales, as HTML: its regions, their stress paths, the packings it kept, and how
// far its failure reaches. Pictures go to `pictures`. Empty for a run that kept nothing of it.
std::string cross_scale_chapter(const results::FinishedRun& run, const fs::path& pictures,
                                const std::optional<report::CriticalLines>& critical) {
    return failure_pattern(run) + region_figures(run, pictures, critical) + packing_figures(run, pictures);
}

std::string number(double value, int digits) {
    return std::isfinite(value) ? fmt::format("{:.{}g}", value, digits) : "not known";
}

std::string decimal(double value, int decimals) {
    return std::isfinite(value) ? fmt::format("{:.{}f}", value, decimals) : "not known";
}

std::string share(double value) {
    return std::isfinite(value) ? fmt::format("{:.1f} %", 100 * value) : "not known";
}

// With the interval of the mean where it is one of several packings.
std::string friction_text(const io::Summary& s) {
    std::string text = decimal(s.number("friction_angle_deg"), 1);
    if (const double interval = s.number("friction_angle_ci95_deg"); interval > 0)
        text += fmt::format(" ± {:.1f}", interval);
    if (const double packings = s.number("friction_packings"); packings > 0)
        text += fmt::format(" ({:.0f} packing{})", packings, packings == 1 ? "" : "s");
    return text;
}

std::vector<Row> result_rows(const results::FinishedRun& run) {
    if (!run.scene.anchor.present) return {};
    const io::Summary& s = run.summary;
    const bool up = results::pulled_up(run.scene), out = s.breakout;
    const double formula = up ? s.n_gamma_meyerhof_adams : s.n_gamma_biarez;
    return {
        {"result", ""},
        {out ? "breakout load Q_u [kN/m]" : "largest load, no breakout [kN/m]",
         decimal(s.breakout_load / 1000, 1)},
        {"breakout factor N_gamma", decimal(s.n_gamma, 2)},
        {"at d/B", decimal(s.breakout_d_over_B, 3)},
        {up ? "N_gamma of Meyerhof & Adams (1968)" : "N_gamma of Biarez et al. (1965)", decimal(formula, 2)},
        {"embedment H/B", number(results::embedment_of(run), 3)},
        {"unit weight γ [kN/m3]", decimal(results::unit_weight(run) / 1000, 1)},
        {"friction angle φ [deg]", friction_text(s)},
        {"late load [kN/m]", decimal(s.late_load / 1000, 1)},
        {"kinetic energy / plate work, at most", number(s.kinetic_to_strain_energy_max, 2)}};
}

std::vector<Row> cost_rows(const results::FinishedRun& run) {
    const io::Summary& s = run.summary;
    return {{"cost", ""},
            {"mode", s.mode},
            {"wall time [s]", number(s.wall_s, 4)},
            {"threads", fmt::format("{}", s.threads)},
            {"material points", fmt::format("{}", s.points)},
            {"MPM steps", fmt::format("{}", s.steps)},
            {"DEM steps", number(double(s.dem_steps), 3)},
            {"RVE updates", number(double(s.rve_updates), 3)}};
}

std::string phase_times(const results::FinishedRun& run) {
    std::vector<Row> rows = {{"phase", "wall time [s]"}};
    for (const auto& [phase, seconds] : run.record.timing) rows.push_back({phase, number(seconds, 3)});
    return rows.size() < 2 ? "" : report::details("Time by phase", report::table(rows));
}

std::string switch_reasons(const io::Summary& s) {
    constexpr std::string_view prefix = "switches ";
    std::string text;
    for (const auto& [name, count] : s.extra)
        if (name.starts_with(prefix) && count > 0)
            text += fmt::format("{}{} {:.0f}", text.empty() ? "" : ", ", name.substr(prefix.size()), count);
    return text.empty() ? "none" : text;
}

std::string load_error(const io::Summary& s) {
    if (std::isnan(s.audit.load_correction)) return "-";
    return fmt::format("{:+.1f} ± {:.1f} %", 100 * s.audit.load_correction, 100 * s.audit.load_ci95);
}

std::vector<Row> screening_rows(const results::FinishedRun& run) {
    const io::Summary& s = run.summary;
    return {{"surrogate, gate and audit", ""},
            {"gate", gate_text(run.scene)},
            {"points handed over, by reason", switch_reasons(s)},
            {"points that are grains at the end", share(s.dem_fraction_final)},
            {"mean over the run", share(s.dem_fraction_mean)},
            {"surrogate updates", number(double(s.surrogate_updates), 3)},
            {"audit: stress error of the surrogate, share of p", audit_text(s)},
            {"audited points", fmt::format("{}", s.audit.points)},
            {"auditors: what the load lacks at the peak, share of it", load_error(s)}};
}

// displacement_0100.png and its like; other pictures of the run have figures of their own.
bool is_field_picture(const std::string& stem) {
    const std::string field = stem.substr(0, stem.rfind('_'));
    return field != stem && std::ranges::find(field_picture_names(), field) != field_picture_names().end();
}

// Those and load.png, regions.png, stress_paths.png and packings' NAME_DDDD.png.
bool is_own_picture(const fs::path& file) {
    const std::string stem = file.stem().string(), number = stem.substr(stem.rfind('_') + 1);
    const bool numbered =
        number != stem && number.size() >= 4 && number.find_first_not_of("0123456789") == std::string::npos;
    const std::string kind = file.extension().string();
    return (kind == ".png" || kind == ".svg" || kind == ".pdf") &&
           (numbered || stem == "load" || stem == "regions" || stem == "stress_paths");
}

// Of many frames those nearest to the breakout and to even steps up to the last.
std::vector<std::size_t> frames_shown(const results::FinishedRun& run, std::size_t most) {
    const results::GroundView view = results::ground_view(run.scene);
    std::vector<double> d;  // from the second frame on: in the first one nothing has moved
    for (std::size_t k = 1; k < run.record.frames; ++k)
        d.push_back(results::mark_of(io::read_run_frame(run.frame_file(), k), view));
    if (d.size() < most) return {};
    std::set<std::size_t> chosen;
    const auto add = [&](double at) {
        const auto nearer = [at](double a, double b) { return std::abs(a - at) < std::abs(b - at); };
        chosen.insert(static_cast<std::size_t>(std::min_element(d.begin(), d.end(), nearer) - d.begin()) + 1);
    };
    add(run.summary.breakout_d_over_B);
    for (std::size_t k = 1; k < most; ++k) add(d.back() * double(k) / double(most - 1));
    return {chosen.begin(), chosen.end()};
}

// What an older report left would pass for this run's.
void clear_pictures(const fs::path& folder) {
    if (!fs::is_directory(folder)) return;
    std::vector<fs::path> old;
    for (const auto& entry : fs::directory_iterator(folder))
        if (is_own_picture(entry.path())) old.push_back(entry.path());
    for (const fs::path& png : old) fs::remove(png);
}

std::string field_figures(const results::FinishedRun& run, const fs::path& pictures) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(pictures))
        if (entry.path().extension() == ".png" && is_field_picture(entry.path().stem().string()))
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::string html = "<div class=\"grid fields\">\n";
    for (const fs::path& file : files) {
        const std::string stem = file.stem().string(), field = stem.substr(0, stem.rfind('_'));
        const double d = std::strtod(stem.substr(stem.rfind('_') + 1).c_str(), nullptr) / 1000;
        if (d == 0) continue;  // nothing has moved
        html += report::figure(file, fmt::format("{} of {}, {}", field, results::title_of(run.scene),
                                                 results::moment_text(d, run.scene.anchor.present)));
    }
    return html + "</div>\n";
}

}  // namespace

std::string run_chapter(const results::FinishedRun& run, const fs::path& pictures,
                        const ChapterOptions& options) {
    clear_pictures(pictures);
    const std::string told = draw_pictures(pictures, run, frames_shown(run, options.frames_max));
    std::string html = fmt::format(
        "<h2 id=\"{0}\">{1}</h2>\n<p class=\"lead\">{0}, {2}, {3} points, {4:.0f} s on {5} threads, scene "
        "{6}, "
        "revision {7}</p>\n",
        xml_escaped(run.folder.string()), xml_escaped(results::title_of(run.scene)), run.summary.mode,
        run.summary.points, run.summary.wall_s, run.summary.threads, run.summary.scene_hash, run.summary.git);
    if (run.scene.anchor.present)
        html += "<div class=\"grid\">\n" + report::table(result_rows(run)) +
                report::figure(pictures / "load.png", "Load against displacement") + "</div>\n";
    html += "<div class=\"grid\">\n<div class=\"screen-only\">" + report::table(cost_rows(run)) + "</div>\n" +
            (run.summary.mode == "screening" ? report::table(screening_rows(run)) : "") + "</div>\n" +
            phase_times(run);
    html += "<h3>Fields</h3>\n" + field_figures(run, pictures);
    html += cross_scale_chapter(run, pictures, options.critical);
    if (told.starts_with("no pictures")) html += "<p class=\"missing\">" + xml_escaped(told) + "</p>\n";
    return html + report::details("Scene", "<pre>" + xml_escaped(run.record.info.scene_text) + "</pre>\n");
}

}  // namespace sandgraph::report

#include "report/cross_scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "io/packing_file.hpp"
#include "report/html.hpp"
#include "report/packing_picture.hpp"
#include "results/failure_table.hpp"

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

}  // namespace

std::string cross_scale_chapter(const results::FinishedRun& run, const fs::path& pictures,
                                const std::optional<report::CriticalLines>& critical) {
    return failure_pattern(run) + region_figures(run, pictures, critical) + packing_figures(run, pictures);
}

}  // namespace sandgraph::report

#include "results/failure_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>

#include "results/ground_view.hpp"

namespace sandgraph::results {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr ShearBand kNoBand{nan, nan, nan, nan, nan, nan, nan};
constexpr SlipSurface kNoSlip{nan, nan, nan, nan, nan};

std::vector<double> numbers(const FailureRow& r) {
    std::vector<double> row = {r.d_over_B,
                               r.surface.highest,
                               r.surface.lowest,
                               r.surface.visible_ahead,
                               r.surface.heave_ahead,
                               r.surface.sink_behind,
                               r.zone.ahead,
                               r.zone.behind,
                               r.zone.above,
                               r.zone.below,
                               r.cavity,
                               r.rotation};
    for (const ShearBand& band : {r.total, r.recent})
        row.insert(row.end(), {band.lower, band.middle, band.upper, band.at_surface, band.edge_at_surface,
                               band.faint_edge_at_surface, band.dilation});
    row.insert(row.end(), {r.slip.K, r.slip.friction, r.slip.greatest, r.slip.before, r.slip.past});
    return row;
}

constexpr const char* kHeader =
    "run,d_over_B,highest_rise,lowest_rise,visible_ahead,heave_ahead,sink_behind,zone_ahead,zone_behind,"
    "zone_above,zone_below,cavity,band_rotation,"
    "band_lower,band_middle,band_upper,band_at_surface,band_edge,band_faint_edge,band_dilation,"
    "recent_lower,recent_middle,recent_upper,recent_at_surface,recent_edge,recent_faint_edge,recent_dilation,"
    "slip_K,slip_friction,slip_greatest,slip_before,slip_past\n";

}  // namespace

std::vector<FailureRow> failure_rows(const FinishedRun& run) {
    const GroundView view = ground_view(run.scene);
    std::vector<FailureRow> rows;
    if (run.record.frames == 0) return rows;
    const io::Frame start = io::read_run_frame(run.frame_file(), 0);
    io::Frame before = start;
    std::vector<EdgeStress> edges;
    if (pulled_up(run.scene)) edges.push_back(edge_stress(start, start, view));
    for (std::size_t k = 1; k < run.record.frames; ++k) {
        io::Frame frame = io::read_run_frame(run.frame_file(), k);
        FailureRow row{frame.d_over_B,
                       surface_shape(frame, view),
                       strained_zone(frame, view),
                       nan,
                       nan,
                       kNoBand,
                       kNoBand,
                       kNoSlip};
        if (pulled_up(run.scene)) {
            row.cavity = cavity_share(frame, view);
            row.rotation = band_rotation(frame, view);
            row.total = shear_band(start, frame, view);
            row.recent = shear_band(before, frame, view);
            edges.push_back(edge_stress(start, frame, view));
        }
        rows.push_back(row);
        before = std::move(frame);
    }
    const std::vector<SlipSurface> slips = slip_surfaces(edges);
    for (std::size_t k = 0; k < slips.size(); ++k) rows[k].slip = slips[k];
    return rows;
}

std::string failure_csv(const std::vector<std::string>& folders) {
    std::string text = kHeader;
    for (const FinishedRun& run : find_runs(folders))
        for (const FailureRow& row : failure_rows(run))
            text += fmt::format("{},{:.4g}\n", run.folder.filename().string(), fmt::join(numbers(row), ","));
    return text;
}

}  // namespace sandgraph::results

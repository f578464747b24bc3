#include "results/slip_surface.hpp"

#include "results/field_values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sandgraph::results {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double at_peak = 0.9;  // of a row's largest ratio

// Each row's largest ratio over the frames of a run, and when.
struct Peak {
    double ratio = 0;
    std::size_t frame = 0;
};

double ratio_of(const EdgeStress& e, std::size_t row) {
    return e.normal[row] > 0 ? e.shear[row] / e.normal[row] : nan;
}

std::vector<Peak> peaks_of(const std::vector<EdgeStress>& frames) {
    std::vector<Peak> peaks(frames.front().normal.size());
    for (std::size_t k = 1; k < frames.size(); ++k)
        for (std::size_t row = 0; row < peaks.size(); ++row)
            if (const double ratio = ratio_of(frames[k], row); ratio > peaks[row].ratio)
                peaks[row] = {ratio, k};
    return peaks;
}

SlipSurface surface_of(const EdgeStress& start, const std::vector<EdgeStress>& frames, std::size_t k,
                       const std::vector<Peak>& peaks) {
    double normal = 0, shear = 0, vertical = 0, greatest = 0;
    SlipSurface s;
    for (std::size_t row = 0; row < peaks.size(); ++row) {
        const double weight = frames[k].normal[row], ratio = ratio_of(frames[k], row);
        if (!std::isfinite(ratio) || !std::isfinite(start.vertical[row])) continue;
        normal += weight, shear += weight * ratio, greatest += weight * peaks[row].ratio;
        vertical += start.vertical[row];
        if (ratio < at_peak * peaks[row].ratio) (peaks[row].frame < k ? s.past : s.before) += weight;
    }
    if (!(normal > 0)) return {nan, nan, nan, nan, nan};
    return {normal / vertical, shear / normal, greatest / normal, s.before / normal, s.past / normal};
}

}  // namespace

EdgeStress edge_stress(const io::Frame& start, const io::Frame& frame, const GroundView& view) {
    const io::Field& stress = field(frame, "stress", 3);
    const double size = view.point_size, half = view.plate_size_y / 2, bottom = start.plate_y + half;
    const double edge = view.plate_size_x / 2 + size / 2;
    const auto rows = static_cast<std::size_t>(std::max(0L, std::lround((view.surface - bottom) / size)));
    EdgeStress e{std::vector<double>(rows), std::vector<double>(rows), std::vector<double>(rows)};
    std::vector<double> weights(rows);
    for (std::size_t p = 0; p < frame.x.size(); ++p) {
        const double row = std::floor((frame.y[p] - bottom) / size);
        const double weight = 1 - std::abs(frame.x[p] - edge) / size;
        if (weight <= 0 || row < 0 || row >= static_cast<double>(rows)) continue;
        const auto k = static_cast<std::size_t>(row);
        weights[k] += weight;
        e.normal[k] += weight * stress.values[3 * p];
        e.vertical[k] += weight * stress.values[3 * p + 1];
        e.shear[k] += weight * std::abs(stress.values[3 * p + 2]);
    }
    for (std::size_t k = 0; k < rows; ++k) {
        const double y = bottom + (static_cast<double>(k) + 0.5) * size;
        const double share = weights[k] > 0 && y > frame.plate_y + half ? 1 / weights[k] : nan;
        e.normal[k] *= share, e.shear[k] *= share, e.vertical[k] *= share;
    }
    return e;
}

std::vector<SlipSurface> slip_surfaces(const std::vector<EdgeStress>& frames) {
    std::vector<SlipSurface> surfaces;
    if (frames.empty()) return surfaces;
    const std::vector<Peak> peaks = peaks_of(frames);
    for (std::size_t k = 1; k < frames.size(); ++k)
        surfaces.push_back(surface_of(frames.front(), frames, k, peaks));
    return surfaces;
}

}  // namespace sandgraph::results

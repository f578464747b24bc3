#include "laboratory/friction_row.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dem/element_test/element_test.hpp"

namespace sandgraph::laboratory {
namespace {

constexpr double late_from = 0.15, degree = std::numbers::pi / 180;

void add_late(FrictionRow& row, const std::vector<dem::BiaxialRow>& test) {
    double sin_phi = 0, porosity = 0, anisotropy = 0, count = 0;
    for (const dem::BiaxialRow& seen : test) {
        if (seen.axial_strain < late_from) continue;
        sin_phi += seen.sin_phi, porosity += seen.seen.porosity, anisotropy += seen.seen.anisotropy;
        ++count;
    }
    count *= static_cast<double>(dem::confining_pressures.size());
    row.late_sin_phi += sin_phi / count;
    row.late_porosity += porosity / count;
    row.late_anisotropy += anisotropy / count;
}

}  // namespace

FrictionRow friction_row(const Specimen& specimen) {
    FrictionRow row{specimen.density, specimen.seed, specimen.porosity, specimen.coordination};
    std::vector<dem::PeakFriction> peaks;
    for (std::size_t k = 0; k < specimen.tests.size(); ++k) {
        peaks.push_back(dem::peak_friction(specimen.tests[k]));
        row.peak[k] = peaks.back().friction_angle;
        add_late(row, specimen.tests[k]);
    }
    row.line = dem::friction_angle(peaks);
    return row;
}

Figures figures(const FrictionRow& r) {
    return {r.porosity,      r.coordination, r.peak[0] / degree, r.peak[1] / degree, r.peak[2] / degree,
            r.line / degree, r.late_sin_phi, r.late_porosity,    r.late_anisotropy};
}

Spread spread(std::span<const FrictionRow> rows) {
    Spread s;
    const double n = static_cast<double>(rows.size());
    for (std::size_t k = 0; k < kFigures.size(); ++k) {
        std::vector<double> values;
        for (const FrictionRow& row : rows) values.push_back(figures(row)[k]);
        for (const double v : values) s.mean[k] += v / n;
        for (const double v : values) s.deviation[k] += (v - s.mean[k]) * (v - s.mean[k]);
        s.deviation[k] = n > 1 ? std::sqrt(s.deviation[k] / (n - 1)) : 0;
        s.least[k] = *std::ranges::min_element(values), s.largest[k] = *std::ranges::max_element(values);
    }
    return s;
}

}  // namespace sandgraph::laboratory

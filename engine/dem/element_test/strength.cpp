#include "dem/element_test/strength.hpp"

#include <cmath>

#include "base/contracts.hpp"

namespace sandgraph::dem {

PeakStrength peak_strength(std::span<const BiaxialRow> rows, double strain) {
    SG_EXPECT(strain > 0);
    PeakStrength peak;
    double largest = 0;
    for (const BiaxialRow& row : rows) {
        if (row.axial_strain > strain * (1 + 1e-9) || row.sin_phi <= largest) continue;
        largest = row.sin_phi;
        peak = {row.axial_strain, row.p, row.q, std::asin(std::min(1.0, row.sin_phi))};
    }
    return peak;
}

double friction_angle(std::span<const PeakStrength> peaks) {
    double pq = 0, pp = 0;
    for (const PeakStrength& s : peaks) pq += s.p * s.q, pp += s.p * s.p;
    return pp > 0 ? std::asin(pq / pp) : 0;
}

}  // namespace sandgraph::dem

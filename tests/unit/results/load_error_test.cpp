#include "results/load_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace sandgraph::results {
namespace {

// The load is 4 % too high and known to 2 % about its peak of 100 kN/m, to 6 % at the end.
std::vector<io::LoadRow> rows() {
    std::vector<io::LoadRow> out;
    for (int k = 0; k <= 100; ++k) {
        io::LoadRow row;
        row.d_over_B = 0.001 * k, row.load = k < 30 ? 3e3 * k : 100e3;
        row.corrected = row.load - 4e3;
        const double half = k < 60 ? 2e3 : 6e3;
        row.low = row.corrected - half, row.high = row.corrected + half;
        out.push_back(row);
    }
    return out;
}

TEST(LoadError, IsToldAsSharesOfThePeakLoad) {
    io::Summary s;
    s.breakout_load = 100e3;
    add_load_error(rows(), {BreakoutKind::zero_slope, 0.035, 100e3}, s.audit);
    EXPECT_NEAR(s.audit.load_correction, -0.04, 1e-12);
    EXPECT_NEAR(s.audit.load_ci95, 0.02, 1e-12);
    EXPECT_NEAR(s.audit.load_ci95_late, 0.06, 1e-12);
    EXPECT_NE(load_error_text(s).find("corrected by -4.0 kN/m (-4.0 +- 2.0 %)"), std::string::npos);
}

TEST(LoadError, OfARunWithoutAuditorsIsNotKnown) {
    const io::Summary s;
    EXPECT_TRUE(std::isnan(s.audit.load_correction));
    EXPECT_EQ(load_error_text(s), "");
}

}  // namespace
}  // namespace sandgraph::results

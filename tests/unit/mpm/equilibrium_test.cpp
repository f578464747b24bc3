#include <gtest/gtest.h>

#include <cmath>

#include "mpm/boundary.hpp"
#include "mpm/layout.hpp"
#include "mpm/transfer.hpp"

namespace sandgraph::mpm {
namespace {

constexpr double cell = 0.1, gravity = 9.81, density = 1700, K0 = 0.6;
constexpr int columns = 10, rows = 12;

struct Case {
    int per_cell;
    double surcharge;
};

class InSituStress : public testing::TestWithParam<Case> {
  protected:
    Points points = lay_out({{0, 0, columns* cell, rows* cell}, cell, GetParam().per_cell, density, {}});
    Grid grid{GridShape{0, 0, cell, columns, rows + 3}};
    Order order;
};

// sigma_yy = -(q + rho g depth) at row centres.
TEST_P(InSituStress, LeavesNoForceOnAnyNodeAwayFromTheSides) {
    for (std::size_t p = 0; p < points.size(); ++p) {
        const double yy = -GetParam().surcharge - density * gravity * (points.row[p] + 0.5) * 2 * points.half;
        points.stress[p] = {K0 * yy, yy, 0};
    }
    refresh(order, points, grid);
    points_to_grid(points, order, grid);
    add_surcharge(GetParam().surcharge, points, grid);
    const double scale = density * gravity * cell * cell;
    for (int j = 1; j <= rows + 2; ++j)
        for (int i = 1; i < columns; ++i) {
            const Node& n = grid.fields[0].nodes[grid.shape.index(i, j)];
            EXPECT_NEAR(n.fx, 0, 1e-11 * scale);
            EXPECT_NEAR(n.fy - n.mass * gravity, 0, 1e-11 * scale) << "row " << j;
        }
}

INSTANTIATE_TEST_SUITE_P(Grounds, InSituStress,
                         testing::Values(Case{1, 0}, Case{4, 0}, Case{9, 0}, Case{1, 30e3}, Case{4, 30e3}),
                         [](const auto& test) {
                             return std::to_string(test.param.per_cell) + "PerCell" +
                                    (test.param.surcharge > 0 ? "UnderSurcharge" : "");
                         });

TEST(Surcharge, PushesWithItsPressureTimesTheWidth) {
    Points points = lay_out({{0.03, 0, 0.83, 0.5}, cell, 1, density, {}});
    Grid grid(GridShape{0, 0, cell, columns, rows});
    Order order;
    refresh(order, points, grid);
    points_to_grid(points, order, grid);
    add_surcharge(5e3, points, grid);
    double sum = 0;
    for (const Node& n : grid.fields[0].nodes) sum += n.fy;
    EXPECT_NEAR(sum, -5e3 * 0.8, 1e-9);
}

}  // namespace
}  // namespace sandgraph::mpm

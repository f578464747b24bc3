#include "results/drag.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace sandgraph::results {
namespace {

io::LoadRow row(double d, double load, double damping, double pic, double inertia) {
    io::LoadRow r;
    r.d_over_B = d, r.load = load;
    r.damping_share = damping, r.pic_share = pic, r.inertia_share = inertia;
    return r;
}

TEST(Drag, IsTheMeanOverTheRowsAboutAPlaceByTheirLoads) {
    const std::vector<io::LoadRow> rows = {row(0.02, 10, 0.5, 0.5, 0.5), row(0.029, 10, 0.01, 0.02, 0.03),
                                           row(0.031, 30, 0.05, 0.06, -0.01), row(0.033, -5, 1, 1, 1)};
    const Drag drag = drag_at(rows, 0.03);
    EXPECT_NEAR(drag.damping, 0.04, 1e-15);
    EXPECT_NEAR(drag.pic, 0.05, 1e-15);
    EXPECT_NEAR(drag.inertia, 0, 1e-15);
    EXPECT_NEAR(drag.sum(), 0.09, 1e-15);
}

TEST(Drag, WhereNothingResistsIsNone) {
    EXPECT_EQ(drag_at({}, 0.03).sum(), 0);
    const std::vector<io::LoadRow> pushed = {row(0.03, -1, 0.5, 0.5, 0.5)};
    EXPECT_EQ(drag_at(pushed, 0.03).sum(), 0);
}

TEST(Drag, LargestIsLookedForBehindTheFirstRise) {
    const std::vector<io::LoadRow> rows = {row(0.001, 1, 0.5, 0, 0), row(0.02, 1, 0.01, 0, 0),
                                           row(0.04, 1, 0.03, 0.04, 0), row(0.06, 1, 0.02, 0, 0)};
    EXPECT_NEAR(largest_drag(rows), 0.07, 1e-15);
}

}  // namespace
}  // namespace sandgraph::results

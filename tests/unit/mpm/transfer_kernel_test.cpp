#include "mpm/transfer_kernel.hpp"

#include <gtest/gtest.h>

#include <hwy/targets.h>
#include <numeric>

#include "mpm/two_field.hpp"
#include "tests/support/random_ground.hpp"

namespace sandgraph::mpm {
namespace {

struct Result {
    std::vector<Node> nodes;
    Points points;
};

std::vector<std::int32_t> ids(const Points& points) {
    std::vector<std::int32_t> all(points.size());
    std::iota(all.begin(), all.end(), 0);
    return all;
}

// 301 points: the last block of eight is short.
Points ground() {
    Points points = support::random_ground(7, 43, 1, 13);
    EXPECT_EQ(points.size() % 8, 5u);
    return points;
}

Grid moving_grid() {
    Grid grid(support::grid_around(7, 43));
    Random random(2);
    for (Motion& m : grid.fields[0].motion)
        m = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-9, 9), random.uniform(-9, 9)};
    return grid;
}

Result transfer() {
    Result r{{}, ground()};
    Grid grid = moving_grid();
    scatter(ids(r.points), r.points, r.points.stress, grid.shape, grid.fields[0].nodes.data());
    r.nodes = grid.fields[0].nodes;
    gather(ids(r.points), grid.shape, grid.fields[0].motion.data(), {1e-3, 0.2}, r.points);
    return r;
}

Result plain() {
    Result r{{}, ground()};
    Grid grid = moving_grid();
    scatter_enriched(ids(r.points), r.points, r.points.stress, grid);
    r.nodes = grid.fields[0].nodes;
    gather_enriched(ids(r.points), grid, {1e-3, 0.2}, r.points);
    return r;
}

void expect_equal(const Result& a, const Result& b) {
    for (std::size_t n = 0; n < a.nodes.size(); ++n) {
        EXPECT_NEAR(a.nodes[n].mass, b.nodes[n].mass, 1e-12);
        EXPECT_NEAR(a.nodes[n].px, b.nodes[n].px, 1e-12);
        EXPECT_NEAR(a.nodes[n].py, b.nodes[n].py, 1e-12);
        EXPECT_NEAR(a.nodes[n].fx, b.nodes[n].fx, 1e-8);
        EXPECT_NEAR(a.nodes[n].fy, b.nodes[n].fy, 1e-8);
    }
    for (std::size_t p = 0; p < a.points.size(); ++p) {
        EXPECT_NEAR(a.points.x[p], b.points.x[p], 1e-14);
        EXPECT_NEAR(a.points.y[p], b.points.y[p], 1e-14);
        EXPECT_NEAR(a.points.vx[p], b.points.vx[p], 1e-13);
        EXPECT_NEAR(a.points.vy[p], b.points.vy[p], 1e-13);
        EXPECT_LT((a.points.F[p] - b.points.F[p]).norm(), 1e-13);
    }
}

TEST(TransferKernel, EveryInstructionSetOfTheMachineGivesThePlainSums) {
    const Result reference = plain();
    int tested = 0;
    for (std::int64_t rest = hwy::SupportedTargets(); rest != 0; rest &= rest - 1) {
        hwy::SetSupportedTargetsForTest(rest & -rest);
        hwy::GetChosenTarget().Update(rest & -rest);
        expect_equal(transfer(), reference);
        ++tested;
    }
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().DeInit();
    EXPECT_GE(tested, 1);
    RecordProperty("instruction_sets", tested);
}

}  // namespace
}  // namespace sandgraph::mpm

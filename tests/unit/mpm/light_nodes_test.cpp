#include "mpm/light_nodes.hpp"

#include <gtest/gtest.h>

#include "base/random.hpp"

namespace sandgraph::mpm {
namespace {

constexpr Boundaries kFree{Side::free, Side::free, Side::free, Side::free};
constexpr double kLimit = 0.1;

// 4 x 4 cells of nodes of mass 1 up to row 2, light ones in row 3, nothing above.
Grid surface() {
    Grid grid({0, 0, 1, 4, 4});
    Field& f = grid.fields[0];
    f.box = whole(grid.shape);
    grid.point_mass = 1;
    Random random(4);
    for (int j = 0; j <= 3; ++j)
        for (int i = 0; i <= 4; ++i) {
            const double m = j < 3 ? 1 : 0.01;
            f.nodes[grid.shape.index(i, j)] = {m,
                                               m * random.uniform(-1, 1),
                                               m * random.uniform(-1, 1),
                                               random.uniform(-1, 1),
                                               random.uniform(-1, 1),
                                               m * i,
                                               m * (j - 0.5),
                                               m};
        }
    return grid;
}

Node sum(const Grid& grid) {
    Node all;
    for (const Node& n : grid.fields[0].nodes)
        all.mass += n.mass, all.px += n.px, all.py += n.py, all.fx += n.fx, all.fy += n.fy;
    return all;
}

TEST(LightNodes, FollowTheColumnBelow) {
    const Grid grid = surface();
    const auto followers = find_followers(grid, kFree, kLimit);
    ASSERT_EQ(followers.size(), 5u);
    for (int i = 0; i <= 4; ++i) {
        const Follower& f = followers[static_cast<std::size_t>(i)];
        EXPECT_EQ(f.node.index, grid.shape.index(i, 3));
        // Of the columns of its neighbours as much on either side, so that a field linear in y goes on.
        double sum = 0, height = 0;
        for (std::size_t k = 0; k < f.count; ++k) {
            const auto row = f.lead[k].index / static_cast<std::size_t>(grid.shape.stride());
            sum += f.weight[k], height += f.weight[k] * (static_cast<double>(row) - 1);
        }
        EXPECT_NEAR(sum, 1, 1e-14);
        EXPECT_NEAR(height, 3, 1e-13);
    }
    EXPECT_TRUE(find_followers(grid, kFree, 0).empty());
}

TEST(LightNodes, KeepMassMomentumAndForce) {
    Grid grid = surface();
    const Node before = sum(grid);
    give(find_followers(grid, kFree, kLimit), grid);
    const Node after = sum(grid);
    EXPECT_NEAR(after.mass, before.mass, 1e-12);
    EXPECT_NEAR(after.px, before.px, 1e-12);
    EXPECT_NEAR(after.py, before.py, 1e-12);
    EXPECT_NEAR(after.fx, before.fx, 1e-12);
    EXPECT_NEAR(after.fy, before.fy, 1e-12);
    EXPECT_EQ(grid.fields[0].nodes[grid.shape.index(2, 3)].mass, 0);
}

// What the forces do on the followers' velocities they do on those of the nodes that they were given to.
TEST(LightNodes, KeepVirtualPower) {
    Grid grid = surface();
    const std::vector<Node> nodes = grid.fields[0].nodes;
    const auto followers = find_followers(grid, kFree, kLimit);
    Random random(9);
    for (Motion& m : grid.fields[0].motion) m = {random.uniform(-1, 1), random.uniform(-1, 1), 0, 0};
    follow(followers, grid);
    const auto power = [&](const std::vector<Node>& of) {
        double p = 0;
        for (std::size_t k = 0; k < of.size(); ++k)
            p += of[k].fx * grid.fields[0].motion[k].vx + of[k].fy * grid.fields[0].motion[k].vy;
        return p;
    };
    const double before = power(nodes);
    give(followers, grid);
    EXPECT_NEAR(power(grid.fields[0].nodes), before, 1e-12);
}

TEST(LightNodes, FollowALinearFieldExactly) {
    Grid grid = surface();
    const auto velocity = [](double x, double y) { return Motion{1 + 2 * x - y, 3 - x + 4 * y, x, -y}; };
    for (int j = 0; j <= 2; ++j)
        for (int i = 0; i <= 4; ++i) grid.fields[0].motion[grid.shape.index(i, j)] = velocity(i, j);
    follow(find_followers(grid, kFree, kLimit), grid);
    for (int i = 0; i <= 4; ++i) {
        const Motion& m = grid.fields[0].motion[grid.shape.index(i, 3)];
        EXPECT_NEAR(m.vx, velocity(i, 3).vx, 1e-12);
        EXPECT_NEAR(m.vy, velocity(i, 3).vy, 1e-12);
        EXPECT_NEAR(m.ay, velocity(i, 3).ay, 1e-12);
    }
}

// A node on a mirror has half of its surroundings: it is light where its row is.
TEST(LightNodes, OnAWallAreLightWhereTheirRowIs) {
    Grid grid = surface();
    for (int j = 0; j <= 3; ++j) {
        Node& n = grid.fields[0].nodes[grid.shape.index(0, j)];
        n.mass = j < 3 ? 0.5 : 0.06;  // 0.12 with its mirror image: heavy
    }
    const Boundaries mirror{Side::mirror, Side::free, Side::free, Side::free};
    EXPECT_EQ(find_followers(grid, mirror, kLimit).size(), 4u);
    EXPECT_EQ(find_followers(grid, kFree, kLimit).size(), 5u);
}

// Across the cut of a plate lies other material: a light node of the roof of a cavity does not follow the
// floor.
TEST(LightNodes, FollowTheirOwnSideOfACut) {
    Grid grid({0, 0, 1, 8, 8});
    grid.point_mass = 1;
    grid.cuts = {{true, true, 4, -10, 18, 0, 1}};
    for (Field& f : grid.fields) {
        f.nodes.resize(grid.shape.size()), f.motion.resize(grid.shape.size());
        f.box = whole(grid.shape);
    }
    const auto put = [&](std::size_t field, int j, double m, double y) {
        for (int i = 0; i <= 8; ++i)
            grid.fields[field].nodes[grid.shape.index(i, j)] = {m, 0, 0, 0, 0, m * i, m * y, m};
    };
    put(0, 3, 1, 3), put(0, 2, 1, 2);    // the floor, below the cut
    put(0, 5, 1, 5.5), put(0, 6, 1, 6);  // the roof, above it
    put(1, 3, 0.01, 4.6);                // the roof's points reach down to a node of the floor's side
    put(0, 4, 0.01, 4.9);                // and to one on their own side
    const auto followers = find_followers(grid, kFree, kLimit);
    ASSERT_EQ(followers.size(), 9u);  // of row 3 no node has a heavy neighbour of the roof
    for (const Follower& f : followers) {
        EXPECT_EQ(f.node.field, 0u);
        for (std::size_t k = 0; k < f.count; ++k) EXPECT_GE(f.lead[k].index, grid.shape.index(-1, 5));
    }
}

}  // namespace
}  // namespace sandgraph::mpm

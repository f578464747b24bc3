#include "mpm/light_nodes.hpp"

#include <algorithm>
#include <array>

#include "base/contracts.hpp"

namespace sandgraph::mpm {
namespace {

// Axes first: of neighbours as heavy as each other a node follows the one along an axis.
constexpr std::array<std::array<int, 2>, 8> kAround{
    {{0, -1}, {0, 1}, {-1, 0}, {1, 0}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};
constexpr double kRoundOff = 1e-14;  // share of a point's mass
constexpr double kEqual = 1e-9;  // masses nearer to each other than that are equal, whatever their last bit

class Search {
  public:
    Search(const Grid& grid, const Boundaries& sides, double limit)
        : grid_(grid), s_(grid.shape), sides_(sides), limit_(limit), least_(kRoundOff * grid.point_mass) {}

    void of_field(std::size_t field, std::vector<Follower>& out) const {
        const NodeBox& b = grid_.fields[field].box;
        for (int j = std::max(b.j0, 0); j <= std::min(b.j1, s_.ny); ++j)
            for (int i = std::max(b.i0, 0); i <= std::min(b.i1, s_.nx); ++i)
                if (const NodeAt n{field, s_.index(i, j)}; is_light(n, i, j)) add_follower(n, i, j, out);
    }

  private:
    const Node& at(NodeAt n) const { return grid_.fields[n.field].nodes[n.index]; }

    // Half of the surroundings of a node on a wall is missing.
    double mass(NodeAt n, int i, int j) const {
        const bool on_x = (i == 0 && sides_.left != Side::free) || (i == s_.nx && sides_.right != Side::free);
        const bool on_y = (j == 0 && sides_.bottom != Side::free) || (j == s_.ny && sides_.top != Side::free);
        return at(n).mass * (on_x ? 2 : 1) * (on_y ? 2 : 1);
    }

    bool is_light(NodeAt n, int i, int j) const {
        const Node& node = at(n);
        return node.mass < limit_ && node.own > least_ && mass(n, i, j) < limit_;
    }

    // The heavy node (i, j) in the field that material about (x, y) has there.
    bool is_heavy(double x, double y, int i, int j, NodeAt& n) const {
        if (i < 0 || j < 0 || i > s_.nx || j > s_.ny) return false;
        n = {grid_.enrichment.enriches(x, y, s_.x(i), s_.y(j)) ? 1u : 0u, s_.index(i, j)};
        return mass(n, i, j) >= limit_;
    }

    void add_follower(NodeAt self, int i, int j, std::vector<Follower>& out) const {
        const Node& n = at(self);
        const double x = n.mx / n.own, y = n.my / n.own;
        double most = 0;
        Follower f{self, self, self, false};
        for (const auto& [di, dj] : kAround) {
            NodeAt near, far;
            if (!is_heavy(x, y, i + di, j + dj, near)) continue;
            const double m = mass(near, i + di, j + dj);
            if (m <= most * (1 + kEqual)) continue;
            most = m, f.near = near;
            f.linear = is_heavy(x, y, i + 2 * di, j + 2 * dj, far);
            f.far = f.linear ? far : near;
        }
        if (most > 0) out.push_back(f);
    }

    const Grid& grid_;
    const GridShape& s_;
    const Boundaries& sides_;
    double limit_, least_;
};

void add(Node& to, const Node& from, double w) {
    to.mass += w * from.mass;
    to.px += w * from.px, to.py += w * from.py;
    to.fx += w * from.fx, to.fy += w * from.fy;
}

}  // namespace

double light_mass(const Points& points, const GridShape& shape) {
    SG_EXPECT(points.size() > 0 && points.half > 0);
    const double across = shape.cell / (2 * points.half);  // points a cell, along an axis
    return 0.125 * points.mass.front() * across * across;
}

std::vector<Follower> find_followers(const Grid& grid, const Boundaries& boundaries, double limit) {
    SG_EXPECT(limit >= 0);
    std::vector<Follower> out;
    if (limit == 0) return out;
    const Search search(grid, boundaries, limit);
    for (std::size_t field = 0; field < grid.fields.size(); ++field) search.of_field(field, out);
    return out;
}

void give(const std::vector<Follower>& followers, Grid& grid) {  // docs/how_it_works.md (eq. 7a)
    const auto node = [&](NodeAt n) -> Node& { return grid.fields[n.field].nodes[n.index]; };
    for (const Follower& f : followers) {
        const Node n = node(f.node);
        add(node(f.near), n, f.linear ? 2 : 1);
        if (f.linear) add(node(f.far), n, -1);
        node(f.node) = Node{};
    }
}

void follow(const std::vector<Follower>& followers, Grid& grid) {  // (eq. 7a)
    const auto motion = [&](NodeAt n) -> Motion& { return grid.fields[n.field].motion[n.index]; };
    for (const Follower& f : followers) {
        const Motion &a = motion(f.near), &b = motion(f.far);
        motion(f.node) =
            f.linear ? Motion{2 * a.vx - b.vx, 2 * a.vy - b.vy, 2 * a.ax - b.ax, 2 * a.ay - b.ay} : a;
    }
}

}  // namespace sandgraph::mpm

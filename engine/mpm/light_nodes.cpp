#include "mpm/light_nodes.hpp"

#include <algorithm>
#include <array>

#include "base/contracts.hpp"

namespace sandgraph::mpm {
namespace {

constexpr std::array<std::array<int, 2>, 8> kAround{
    {{0, -1}, {0, 1}, {-1, 0}, {1, 0}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};
constexpr double kRoundOff = 1e-14;  // share of a point's mass

// Takes the index k of an image to that of its original and turns its sign; false where there is no node.
bool original(int& k, int last, Side low, Side high, bool between, double& sign) {
    const int first = between ? 1 : 0, image_low = between ? 1 : 0, image_high = 2 * last - image_low;
    if (k < first && low == Side::mirror) return k = image_low - k, sign = -sign, k <= last;
    if (k > last - first && high == Side::mirror) return k = image_high - k, sign = -sign, k >= 0;
    return k >= first && k <= last - first;
}

// Eighth power.
double rank(double mass) {
    const double two = mass * mass, four = two * two;
    return four * four;
}

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
        const bool on_x = !sides_.between_x && ((i == 0 && sides_.left != Side::free) ||
                                                (i == s_.nx && sides_.right != Side::free));
        const bool on_y = !sides_.between_y && ((j == 0 && sides_.bottom != Side::free) ||
                                                (j == s_.ny && sides_.top != Side::free));
        return at(n).mass * (on_x ? 2 : 1) * (on_y ? 2 : 1);
    }

    bool is_light(NodeAt n, int i, int j) const {
        const Node& node = at(n);
        return node.mass < limit_ && node.own > least_ && mass(n, i, j) < limit_;
    }

    // The heavy node (i, j) in the field that material about (x, y) has there; behind a mirror plane the
    // original of the image.
    bool is_heavy(double x, double y, int i, int j, NodeAt& n) const {
        n = {};
        if (!original(i, s_.nx, sides_.left, sides_.right, sides_.between_x, n.sx)) return false;
        if (!original(j, s_.ny, sides_.bottom, sides_.top, sides_.between_y, n.sy)) return false;
        n.field = grid_.enriches(x, y, s_.x(i), s_.y(j)) ? 1u : 0u;
        n.index = s_.index(i, j);
        return mass(n, i, j) >= limit_;
    }

    // Every heavy neighbour with another behind it carries the node on along their line, the heaviest most:
    // equals share, and a last bit decides nothing. Where there is no such line the node goes with its
    // neighbours.
    void add_follower(NodeAt self, int i, int j, std::vector<Follower>& out) const {
        const Node& n = at(self);
        const double x = n.mx / n.own, y = n.my / n.own;
        for (const bool linear : {true, false}) {
            const Follower f = carried(self, x, y, i, j, linear);
            if (f.count > 0) return out.push_back(f);
        }
    }

    Follower carried(NodeAt self, double x, double y, int i, int j, bool linear) const {
        Follower f{self, {}, {}, 0};
        double sum = 0;
        for (const auto& [di, dj] : kAround) {
            NodeAt near, far;
            if (!is_heavy(x, y, i + di, j + dj, near)) continue;
            if (linear && !is_heavy(x, y, i + 2 * di, j + 2 * dj, far)) continue;
            const double w = rank(mass(near, i + di, j + dj) / limit_);
            f.add(near, linear ? 2 * w : w);
            if (linear) f.add(far, -w);
            sum += w;
        }
        for (double& w : f.weight) w /= sum > 0 ? sum : 1;
        return f;
    }

    const Grid& grid_;
    const GridShape& s_;
    const Boundaries& sides_;
    double limit_, least_;
};

void add(Node& to, const Node& from, double w, const NodeAt& at) {
    const double wx = w * at.sx, wy = w * at.sy;
    to.mass += w * from.mass;
    to.px += wx * from.px, to.py += wy * from.py;
    to.fx += wx * from.fx, to.fy += wy * from.fy;
}

}  // namespace

double light_mass(const Points& points, const GridShape& shape) {
    SG_EXPECT(points.size() > 0 && points.half > 0);
    return 0.1 * points.mass.front() / points.volume0.front() * shape.cell * shape.cell;
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
        for (std::size_t k = 0; k < f.count; ++k) add(node(f.lead[k]), n, f.weight[k], f.lead[k]);
        node(f.node) = Node{};
    }
}

void follow(const std::vector<Follower>& followers, Grid& grid) {  // (eq. 7a)
    const auto motion = [&](NodeAt n) -> Motion& { return grid.fields[n.field].motion[n.index]; };
    for (const Follower& f : followers) {
        Motion sum;
        for (std::size_t k = 0; k < f.count; ++k) {
            const Motion& m = motion(f.lead[k]);
            const double wx = f.weight[k] * f.lead[k].sx, wy = f.weight[k] * f.lead[k].sy;
            sum.vx += wx * m.vx, sum.vy += wy * m.vy, sum.ax += wx * m.ax, sum.ay += wy * m.ay;
        }
        motion(f.node) = sum;
    }
}

}  // namespace sandgraph::mpm

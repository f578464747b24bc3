#include "simulation/history_points.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "base/random.hpp"

namespace sandgraph::simulation {
namespace {

constexpr double kNear = 1.5, kEdge = 0.5;  // in plate widths

double distance(const mpm::Rectangle& r, double x, double y) {
    return std::hypot(std::max({r.x0 - x, 0.0, x - r.x1}), std::max({r.y0 - y, 0.0, y - r.y1}));
}

// To the nearer one of the short sides, the plate's edges.
double distance_to_edge(const mpm::Rectangle& r, double x, double y) {
    const bool lying = r.x1 - r.x0 > r.y1 - r.y0;
    const mpm::Rectangle first = lying ? mpm::Rectangle{r.x0, r.y0, r.x0, r.y1}
                                       : mpm::Rectangle{r.x0, r.y0, r.x1, r.y0},
                         second = lying ? mpm::Rectangle{r.x1, r.y0, r.x1, r.y1}
                                        : mpm::Rectangle{r.x0, r.y1, r.x1, r.y1};
    return std::min(distance(first, x, y), distance(second, x, y));
}

class Drawing {
  public:
    Drawing(const mpm::Points& points, std::uint64_t seed) : points_(points), random_(seed, 7) {}

    // One of each of `count` equal shares of the points that `wanted` takes, in the order of their ids.
    void draw(std::size_t count, const std::function<bool(double, double)>& wanted) {
        std::vector<std::int32_t> from;
        for (std::size_t p = 0; p < points_.size(); ++p)
            if (wanted(points_.x[p], points_.y[p]) && !chosen_.contains(static_cast<std::int32_t>(p)))
                from.push_back(static_cast<std::int32_t>(p));
        count = std::min(count, from.size());
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t begin = k * from.size() / count, end = (k + 1) * from.size() / count;
            chosen_.insert(from[begin + static_cast<std::size_t>(random_.uniform() * double(end - begin))]);
        }
    }
    std::size_t size() const { return chosen_.size(); }
    std::vector<std::int32_t> points() const { return {chosen_.begin(), chosen_.end()}; }

  private:
    const mpm::Points& points_;
    Random random_;
    std::set<std::int32_t> chosen_;
};

}  // namespace

std::vector<std::int32_t> history_points(const mpm::Points& points,
                                         const std::optional<mpm::Rectangle>& plate, double width, int count,
                                         std::uint64_t seed) {
    const auto total = static_cast<std::size_t>(count);
    Drawing drawing(points, seed);
    if (plate) {
        drawing.draw(total / 4,
                     [&](double x, double y) { return distance_to_edge(*plate, x, y) < kEdge * width; });
        drawing.draw(total / 4, [&](double x, double y) { return distance(*plate, x, y) < kNear * width; });
    }
    drawing.draw(total - drawing.size(), [](double, double) { return true; });
    return drawing.points();
}

}  // namespace sandgraph::simulation

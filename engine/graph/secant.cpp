#include "graph/secant.hpp"

#include <algorithm>
#include <cmath>

namespace sandgraph::graph {
namespace {

constexpr double kMemory = 0.5;    // share of what was known that stays
constexpr double kSameWay = 0.5;   // cosine below which nothing of it does
constexpr double kStraight = 0.7;  // a path whose ends lie nearer than this share of its length has turned
constexpr double kLeast = 1e-12;   // a strain below it tells nothing

Stress mixed(double share, const Stress& a, const Stress& b) {
    Stress out = scaled(share, a);
    add(out, scaled(1 - share, b));
    return out;
}

bool finite(const Stress& s) { return std::isfinite(s.xx) && std::isfinite(s.yy) && std::isfinite(s.xy); }

// No more than takes the whole elastic stiffness that way: a prediction must not give off work as it goes on.
Stress bounded(const Stress& slope, const Stress& way, const PlaneModuli& moduli) {
    const double elastic = product(elastic_stress(moduli, way), way), along = product(slope, way);
    return along > elastic ? scaled(elastic / along, slope) : slope;
}

}  // namespace

void Secants::learn(std::size_t point, const Mat2& collected, const Stress& beyond,
                    const PlaneModuli& moduli) {
    Secant& q = all_[point];
    const Stress strain = small_strain(collected);
    const double size = norm(strain), progress = std::exchange(q.progress, 0.0),
                 travel = std::exchange(q.travel, 0.0);
    if (!(size > kLeast)) return;
    const Stress way = scaled(1 / size, strain);
    const bool goes_on = product(way, q.way) > kSameWay;
    if (!goes_on && size < kStraight * travel) return;  // to and fro: it tells of no way
    const double extent = std::max(size, progress), kept = goes_on ? kMemory : 0;
    const Stress slope = scaled(1 / extent, difference(scaled(progress, q.slope), beyond));
    q.way = mixed(kept, q.way, way);
    q.way = scaled(1 / norm(q.way), q.way);
    q.slope = bounded(mixed(kept, q.slope, slope), q.way, moduli);
    if (!goes_on) q.position = 0;
}

Stress Secants::shortfall_ahead(std::size_t point, const Stress& strain) const {
    const Secant& q = all_[point];
    return scaled(std::max(0.0, q.position + product(q.way, strain)), q.slope);
}

void Secants::load(ByteReader& in) {
    in.take_same(all_);
    for (const Secant& q : all_)
        require_state(finite(q.way) && finite(q.slope) && q.position <= 0 && q.progress >= 0 && q.travel >= 0,
                      "numbers");
}

}  // namespace sandgraph::graph

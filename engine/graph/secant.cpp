#include "graph/secant.hpp"

#include <cmath>

#include "graph/stress_arithmetic.hpp"

namespace sandgraph::graph {
namespace {

constexpr double kMemory = 0.5;   // share of what was known that stays
constexpr double kSameWay = 0.5;  // cosine below which nothing of it does
constexpr double kLeast = 1e-12;  // a strain below it tells nothing

Stress scaled(double factor, const Stress& s) { return {factor * s.xx, factor * s.yy, factor * s.xy}; }

Stress mixed(double share, const Stress& a, const Stress& b) {
    Stress out = scaled(share, a);
    add(out, scaled(1 - share, b));
    return out;
}

Stress small_strain(const Mat2& F) { return {F(0, 0) - 1, F(1, 1) - 1, 0.5 * (F(0, 1) + F(1, 0))}; }

double product(const Stress& a, const Stress& b) { return a.xx * b.xx + a.yy * b.yy + 2 * a.xy * b.xy; }

bool finite(const Stress& s) { return std::isfinite(s.xx) && std::isfinite(s.yy) && std::isfinite(s.xy); }

}  // namespace

void Secants::learn(std::size_t point, const Mat2& collected, const Stress& beyond) {
    Secant& q = all_[point];
    const Stress strain = small_strain(collected);
    const double size = norm(strain);
    if (!(size > kLeast)) return;
    const Stress way = scaled(1 / size, strain),
                 slope = scaled(1 / size, difference(scaled(q.along, q.slope), beyond));
    const double kept = product(way, q.way) > kSameWay ? kMemory : 0;
    q.way = mixed(kept, q.way, way);
    q.way = scaled(1 / norm(q.way), q.way);
    q.slope = mixed(kept, q.slope, slope);
    q.along = 0;
}

void Secants::load(ByteReader& in) {
    in.take_same(all_);
    for (const Secant& q : all_)
        require_state(finite(q.way) && finite(q.slope) && std::isfinite(q.along), "numbers");
}

}  // namespace sandgraph::graph

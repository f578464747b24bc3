#include "graph/screening/power_draw.hpp"

#include <algorithm>

#include "base/contracts.hpp"
#include "base/random.hpp"

namespace sandgraph::graph {
namespace {

// What chances are in proportion to: sums to 1 over the points that can be drawn.
std::vector<double> shares(std::span<const double> size, double evenly) {
    double sum = 0, count = 0;
    for (const double s : size)
        if (s >= 0) sum += s, ++count;
    if (sum <= 0) evenly = 1;  // nothing to go by
    std::vector<double> out;
    for (const double s : size)
        out.push_back(s >= 0 ? evenly / count + (sum > 0 ? (1 - evenly) * s / sum : 0) : 0);
    return out;
}

// What the shares have to be raised by so that the chances add up to `expected`, where those of the last
// factor that pass 1 count as 1.
double raised(std::span<const double> share, double expected, double factor) {
    double certain = 0, rest = 0;
    for (const double s : share) s* factor >= 1 ? ++certain : rest += s;
    return rest > 0 && expected > certain ? (expected - certain) / rest : factor;
}

}  // namespace

std::vector<double> chances(std::span<const double> size, double expected, double evenly) {
    SG_EXPECT(expected >= 0 && evenly > 0 && evenly <= 1);
    std::vector<double> out = shares(size, evenly);
    double factor = expected;
    for (int k = 0; k < 50; ++k) {  // the set of certain points only grows: a few rounds are enough
        const double next = raised(out, expected, factor);
        if (next <= factor) break;
        factor = next;
    }
    for (double& s : out) s = std::min(1.0, factor * s);
    return out;
}

std::vector<double> permanent_numbers(std::size_t points, std::uint64_t seed) {
    Random random(seed, 0x10AD);
    std::vector<double> out(points);
    for (double& u : out) u = random.uniform();
    return out;
}

}  // namespace sandgraph::graph

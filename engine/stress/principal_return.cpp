#include "stress/principal_return.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/contracts.hpp"

namespace sandgraph::stress {
namespace {

// Equations: docs/how_it_works.md.
// Linear form n . s - k over principal stresses, and the stress direction D m of flow on the same plane.
struct Plane {
    Principal normal, flow;
};

double dot(const Principal& a, const Principal& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Principal minus(const Principal& s, double gamma, const Principal& d) {
    return {s[0] - gamma * d[0], s[1] - gamma * d[1], s[2] - gamma * d[2]};
}

// The plane on which principal `major` is largest and `minor` smallest.
Plane plane(std::size_t major, std::size_t minor, const MohrCoulombConstants& k) {
    const ElasticConstants elastic = k.elastic();
    Plane p{};
    p.normal[major] = 1 + std::sin(k.friction_angle);
    p.normal[minor] = std::sin(k.friction_angle) - 1;
    const double up = 1 + std::sin(k.dilation_angle), down = std::sin(k.dilation_angle) - 1;
    p.flow.fill(elastic.lame() * (up + down));
    p.flow[major] += 2 * elastic.shear() * up;
    p.flow[minor] += 2 * elastic.shear() * down;
    return p;
}

double limit(const MohrCoulombConstants& k) { return 2 * k.cohesion * std::cos(k.friction_angle); }

bool ordered(const Principal& s, double slack) { return s[0] >= s[1] - slack && s[1] >= s[2] - slack; }

// Return to the line where planes a and b meet (eq. 34b); nothing if a multiplier is negative or the order is
// lost.
std::optional<Principal> return_to_edge(const Principal& trial, const Plane& a, const Plane& b, double k,
                                        double slack) {
    const double aa = dot(a.normal, a.flow), ab = dot(a.normal, b.flow), ba = dot(b.normal, a.flow),
                 bb = dot(b.normal, b.flow);
    const double fa = dot(a.normal, trial) - k, fb = dot(b.normal, trial) - k, det = aa * bb - ab * ba;
    const double ga = (fa * bb - fb * ab) / det, gb = (fb * aa - fa * ba) / det;
    const Principal s = minus(minus(trial, ga, a.flow), gb, b.flow);
    if (ga < 0 || gb < 0 || !ordered(s, slack)) return std::nullopt;
    return s;
}

// (eq. 34c)
Principal apex(const MohrCoulombConstants& k) {
    const double s = k.cohesion / std::tan(k.friction_angle);
    return {s, s, s};
}

}  // namespace

// (eq. 34)
double yield(double s1, double s3, const MohrCoulombConstants& k) {
    return (s1 - s3) + (s1 + s3) * std::sin(k.friction_angle) - limit(k);
}

Principal return_to_yield(const Principal& trial, const MohrCoulombConstants& k) {
    SG_EXPECT(!(trial[0] < trial[1]) && !(trial[1] < trial[2]));
    SG_EXPECT(k.friction_angle >= k.dilation_angle && k.cohesion >= 0);
    const double slack = 1e-12 * (std::fabs(trial[0]) + std::fabs(trial[2]));
    const double excess = yield(trial[0], trial[2], k);
    if (excess <= 0) return trial;
    const Plane main = plane(0, 2, k);
    // (eq. 34a)
    const Principal on_plane = minus(trial, excess / dot(main.normal, main.flow), main.flow);
    if (ordered(on_plane, slack)) return on_plane;
    // s2 meets s1 (right edge) or s3 (left edge); the nearer one first.
    const bool meets_major = on_plane[1] > on_plane[0];
    const Plane right = plane(1, 2, k), left = plane(0, 1, k);
    for (const Plane& other : {meets_major ? right : left, meets_major ? left : right})
        if (const auto s = return_to_edge(trial, main, other, limit(k), slack)) return *s;
    return apex(k);
}

}  // namespace sandgraph::stress

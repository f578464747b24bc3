#include "mpm/audit.hpp"

#include <numeric>

#include "base/contracts.hpp"

namespace sandgraph::mpm {

double total_mass(const Points& points) {
    return std::accumulate(points.mass.begin(), points.mass.end(), 0.0);
}

Vec2 momentum(const Points& points) {
    Vec2 sum = Vec2::Zero();
    for (std::size_t p = 0; p < points.size(); ++p) sum += points.mass[p] * Vec2(points.vx[p], points.vy[p]);
    return sum;
}

double angular_momentum(const Points& points) {
    double sum = 0;
    for (std::size_t p = 0; p < points.size(); ++p)
        sum += points.mass[p] * (points.x[p] * points.vy[p] - points.y[p] * points.vx[p]);
    return sum;
}

double kinetic_energy(const Points& points, double mass_scaling) {
    SG_EXPECT(mass_scaling > 0);
    double sum = 0;
    for (std::size_t p = 0; p < points.size(); ++p)
        sum += points.mass[p] * (points.vx[p] * points.vx[p] + points.vy[p] * points.vy[p]);
    return 0.5 * mass_scaling * sum;
}

double gravity_potential(const Points& points, const Vec2& gravity) {
    double sum = 0;
    for (std::size_t p = 0; p < points.size(); ++p)
        sum -= points.mass[p] * (gravity.x() * points.x[p] + gravity.y() * points.y[p]);
    return sum;
}

double stress_work(const Points& points) {
    SG_EXPECT(points.F_inc.size() == points.size() && points.stress.size() == points.size());
    double sum = 0;
    for (std::size_t p = 0; p < points.size(); ++p) {
        const Mat2& F = points.F_inc[p];
        const Stress& s = points.stress[p];
        sum += points.volume[p] * (s.xx * (F(0, 0) - 1) + s.yy * (F(1, 1) - 1) + s.xy * (F(0, 1) + F(1, 0)));
    }
    return sum;
}

double plate_work(const RigidPlate& plate, const Reaction& reaction, double dt) {
    return -dt * reaction.total().dot(plate.velocity);
}

}  // namespace sandgraph::mpm

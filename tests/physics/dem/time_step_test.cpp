// The DEM step against the packing's own stability limit: the fastest vibration of its grains when every
// contact sticks.
#include <numbers>

#include "dem/make_assembly.hpp"
#include "dem/packing/observe.hpp"
#include "dem/prepare/prepare.hpp"
#include "dem/rve_options.hpp"
#include "dem/time_step.hpp"
#include "public_packing.hpp"

namespace sandgraph::dem {
namespace {

using Motion = std::vector<Eigen::Vector3d>;  // of each grain: x, y, turn

// -M^-1 K u with normal, tangential and rolling springs.
Motion accelerations(const Packing& p, std::span<const ContactForce> contacts, const Material& m,
                     const Motion& u) {
    Motion a(p.size(), Eigen::Vector3d::Zero());
    for (const ContactForce& c : contacts) {
        const double ri = p.r[c.i], rj = p.r[c.j];
        const double k_n = m.young * 2 * ri * rj / (ri + rj), k_t = m.stiffness_ratio * k_n;
        const Vec2 n = c.n, t(n.y(), -n.x()), apart = u[c.j].head<2>() - u[c.i].head<2>();
        const double slip = k_t * (apart.dot(t) + rj * u[c.j].z() + ri * u[c.i].z());
        const double roll = m.rolling_stiffness * k_t * ri * rj * (u[c.j].z() - u[c.i].z());
        const Vec2 force = k_n * apart.dot(n) * n + slip * t;
        a[c.j] += Eigen::Vector3d(force.x(), force.y(), rj * slip + roll);
        a[c.i] += Eigen::Vector3d(-force.x(), -force.y(), ri * slip - roll);
    }
    for (std::size_t g = 0; g < p.size(); ++g) {
        a[g] /= m.density * m.depth * std::numbers::pi * p.r[g] * p.r[g];
        a[g].z() *= 2 / (p.r[g] * p.r[g]);
    }
    return a;
}

double size(const Motion& u, const Packing& p) {  // in the norm of the mass matrix
    double sum = 0;
    for (std::size_t g = 0; g < u.size(); ++g)
        sum += p.r[g] * p.r[g] * (u[g].head<2>().squaredNorm() + 0.5 * std::pow(p.r[g] * u[g].z(), 2));
    return std::sqrt(sum);
}

// 2/omega of the fastest mode [s], by power iteration; from above.
double stability_limit(const Packing& p, const Material& m) {
    const auto contacts = contact_forces(p, m);
    Motion u;
    for (std::size_t g = 0; g < p.size(); ++g) {
        const auto k = static_cast<double>(g);
        u.emplace_back(std::sin(k), std::cos(2.7 * k), 200 * std::sin(4.1 * k));
    }
    double omega2 = 0;
    for (int round = 0; round < 2000; ++round) {
        const double before = size(u, p);
        for (auto& v : u) v /= before;
        u = accelerations(p, contacts, m, u);
        omega2 = size(u, p);
    }
    return 2 / std::sqrt(omega2);
}

Packing at_pressure(const Packing& p, double pressure) {
    return compress_to(p, {.pressure = pressure}, {}, fast_assemblies());
}

TEST(TimeStep, CriticalOneIsStableAtAnyPressure) {
    for (const std::string kind : {"dense", "loose"})
        for (const double pressure : {32e3, 1e6}) {
            const Packing p = at_pressure(test::public_packing(kind), pressure);
            const double share = critical_time_step({}, p.r) / stability_limit(p, {});
            EXPECT_LT(share, 1) << kind << pressure;
            EXPECT_GT(share, 0.7) << kind << pressure;  // nor far too careful
        }
}

TEST(TimeStep, CriticalOneIsStableForOtherMaterials) {
    const Packing p = at_pressure(test::public_packing("dense"), 1e6);
    for (const double stiffness_ratio : {0.1, 0.5, 1.0})
        for (const double rolling_stiffness : {0.0, 1.0, 3.0}) {
            Material material;
            material.stiffness_ratio = stiffness_ratio, material.rolling_stiffness = rolling_stiffness;
            const double share = critical_time_step(material, p.r) / stability_limit(p, material);
            EXPECT_LT(share, 1) << stiffness_ratio << ' ' << rolling_stiffness;
        }
}

// Equal disks on a hexagonal lattice, six contacts each: the stiffest packing there is.
Packing crystal(double radius, int side) {
    const double d = 1.999 * radius;
    Packing p;
    p.H << side * d, 0, 0, side * d * std::sqrt(0.75);
    for (int row = 0; row < side; ++row)
        for (int k = 0; k < side; ++k) {
            p.x.push_back((k + 0.5 * (row % 2)) * d), p.y.push_back(row * d * std::sqrt(0.75));
            p.r.push_back(radius);
        }
    return p;
}

TEST(TimeStep, DefaultOneIsStableForACrystalOfEqualDisks) {
    const Packing p = crystal(0.005, 6);
    ASSERT_EQ(contact_forces(p, {}).size(), 3 * p.size());
    EXPECT_LT(rve_options({}, {}, p.r).time_step, stability_limit(p, {}));
}

}  // namespace
}  // namespace sandgraph::dem

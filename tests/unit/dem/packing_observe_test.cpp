#include <gtest/gtest.h>

#include "dem/packing/csv.hpp"
#include "dem/packing/observe.hpp"
#include "dem/reference/reference.hpp"
#include "yade_reference.hpp"

namespace sandgraph::dem {
namespace {

Packing sheared() {
    ReferenceAssembly assembly(read_packing_csv(test::yade_file("packing_dense_p32.csv")), Material{});
    assembly.step((Mat2() << 0, 0.4, 0, 0).finished(), 1e-5, 3000);
    return assembly.packing();
}

// Normal stress part and contact count by plain loops over pairs and the nine nearest images.
struct BruteForce {
    Mat2 stress = Mat2::Zero(), fabric = Mat2::Zero();
    int contacts = 0;
    double energy = 0, overlap_max = 0;

    BruteForce(const Packing& p, const Material& m) {
        for (std::size_t i = 0; i < p.size(); ++i)
            for (std::size_t j = i + 1; j < p.size(); ++j)
                for (int a = -1; a <= 1; ++a)
                    for (int b = -1; b <= 1; ++b) add(p, m, i, j, p.H * Vec2(a, b));
        stress /= p.H.determinant() * m.depth;
        fabric /= contacts;
    }
    void add(const Packing& p, const Material& m, std::size_t i, std::size_t j, const Vec2& shift) {
        const Vec2 d(p.x[j] + shift.x() - p.x[i], p.y[j] + shift.y() - p.y[i]);
        const double overlap = p.r[i] + p.r[j] - d.norm();
        if (overlap <= 0) return;
        const double k = m.young * 2 * p.r[i] * p.r[j] / (p.r[i] + p.r[j]);
        stress += k * overlap / d.norm() * d * d.transpose();
        fabric += d * d.transpose() / d.squaredNorm();
        energy += 0.5 * k * overlap * overlap;
        overlap_max = std::max(overlap_max, overlap);
        ++contacts;
    }
};

TEST(Observe, AgreesWithBruteForceOnNormalForces) {
    Packing p = sheared();
    p.contacts.clear();
    const Material material;
    const BruteForce expected(p, material);
    const Observables seen = observe(p, contact_forces(p, material), material);
    EXPECT_EQ(seen.contacts, expected.contacts);
    EXPECT_LT((seen.stress - expected.stress).norm(), 1e-12 * expected.stress.norm());
    EXPECT_LT((seen.fabric - expected.fabric).norm(), 1e-13);
    EXPECT_NEAR(seen.elastic_normal, expected.energy, 1e-12 * expected.energy);
    EXPECT_NEAR(seen.overlap_max, expected.overlap_max, 1e-16);
    EXPECT_NEAR(seen.coordination, 2.0 * expected.contacts / 400, 1e-15);
}

TEST(Observe, TakesHistoryFromThePacking) {
    const Packing p = sheared();
    Packing bare = p;
    bare.contacts.clear();
    const Material material;
    const Observables with = observe(p, contact_forces(p, material), material);
    const Observables without = observe(bare, contact_forces(bare, material), material);
    EXPECT_GT(with.elastic_tangential, 0);
    EXPECT_GT(with.elastic_rolling, 0);
    EXPECT_EQ(without.elastic_tangential, 0);
    EXPECT_EQ(with.elastic_normal, without.elastic_normal);
    EXPECT_LT(with.unbalanced, without.unbalanced);  // friction carries its share
}

// Two equal disks in a square cell, touching along x, the tangential force at the Coulomb limit.
TEST(Observe, TwoDisksByHand) {
    Packing p;
    p.H = 0.1 * Mat2::Identity();
    p.x = {0.04, 0.0499}, p.y = {0.05, 0.05}, p.r = {0.005, 0.005};
    p.vx = {1, -1}, p.vy = {0, 0}, p.spin = {10, 0};
    const Material material;
    const double f_n = 4e6 * 1e-4, f_t = f_n * std::tan(material.friction_angle);
    p.contacts = {{0, 1, 0, 0, -f_t, 0.02}};
    const Observables seen = observe(p, contact_forces(p, material), material);
    const double mass = 2650 * 0.1 * std::numbers::pi * 25e-6;
    EXPECT_NEAR(seen.stress(0, 0), 0.0099 * f_n / (0.01 * 0.1), 1e-6);
    EXPECT_NEAR(seen.stress(0, 1), 0.0099 * f_t / (0.01 * 0.1), 1e-6);  // e = (0, -1), so f_y = +f_t
    EXPECT_EQ(seen.stress(1, 1), 0);
    EXPECT_NEAR(seen.anisotropy, 2, 1e-12);
    EXPECT_EQ(seen.sliding_fraction, 1);
    EXPECT_EQ(seen.coordination, 1);
    EXPECT_EQ(seen.mechanical_coordination, 0);  // no disk has two contacts
    EXPECT_NEAR(seen.kinetic_translation, mass, 1e-12 * mass);
    EXPECT_NEAR(seen.kinetic_rotation, 0.5 * (0.5 * mass * 25e-6) * 100, 1e-12);
    EXPECT_NEAR(seen.elastic_tangential, f_t * f_t / (2 * 2e6), 1e-9);
    EXPECT_NEAR(seen.elastic_rolling, 0.02 * 0.02 / (2 * 2e6 * 25e-6), 1e-9);
    EXPECT_NEAR(seen.unbalanced, 1, 1e-12);
    EXPECT_NEAR(seen.porosity, 1 - 2 * std::numbers::pi * 25e-6 / 0.01, 1e-14);
}

TEST(Observe, MeanFlowIsNotKineticEnergy) {
    Packing p;
    p.H = 0.1 * Mat2::Identity();
    p.L = (Mat2() << 0.3, 2, -1, 0.1).finished();
    p.x = {0.02, 0.07}, p.y = {0.03, 0.08}, p.r = {0.005, 0.004}, p.spin = {0, 0};
    for (int g = 0; g < 2; ++g) {
        const Vec2 v = p.L * Vec2(p.x[g], p.y[g]);
        p.vx.push_back(v.x()), p.vy.push_back(v.y());
    }
    const Observables seen = observe(p, contact_forces(p, Material{}), Material{});
    EXPECT_NEAR(seen.kinetic_translation, 0, 1e-20);
    EXPECT_EQ(seen.contacts, 0);
    EXPECT_EQ(seen.anisotropy, 0);
}

}  // namespace
}  // namespace sandgraph::dem

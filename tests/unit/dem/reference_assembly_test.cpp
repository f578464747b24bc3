#include <gtest/gtest.h>

#include "dem/packing/csv.hpp"
#include "dem/reference/reference.hpp"
#include "yade_reference.hpp"

namespace sandgraph::dem {
namespace {

constexpr double dt = 1e-5;

Mat2 gradient(double xx, double xy, double yx, double yy) { return (Mat2() << xx, xy, yx, yy).finished(); }
Packing dense() { return read_packing_csv(test::yade_file("packing_dense_p32.csv")); }

double relative(const Mat2& a, const Mat2& b) { return (a - b).norm() / b.norm(); }

TEST(ReferenceAssembly, DoesNotDependOnTheChoiceOfPeriods) {
    Packing skewed = dense();
    skewed.H.col(1) += 3 * skewed.H.col(0);
    ReferenceAssembly a(dense(), Material{}), b(skewed, Material{});
    for (Assembly* each : {static_cast<Assembly*>(&a), static_cast<Assembly*>(&b)})
        each->step(gradient(0.1, 0.4, 0, -0.1), dt, 200);
    EXPECT_LT(relative(b.stress(), a.stress()), 1e-10);
    EXPECT_EQ(a.observe().contacts, b.observe().contacts);
}

TEST(ReferenceAssembly, DoesNotDependOnWhichImageAGrainIsGivenIn) {
    Packing moved = dense();
    for (std::size_t g = 0; g < moved.size(); g += 3) {
        moved.x[g] += 2 * moved.H(0, 0);
        moved.y[g] -= moved.H(1, 1);
    }
    ReferenceAssembly a(dense(), Material{}), b(moved, Material{});
    for (Assembly* each : {static_cast<Assembly*>(&a), static_cast<Assembly*>(&b)})
        each->step(gradient(0.1, 0.4, 0, -0.1), dt, 200);
    EXPECT_LT(relative(b.stress(), a.stress()), 1e-10);
}

TEST(ReferenceAssembly, StressIsSymmetricAtRest) {
    Material calm;
    calm.damping = 0.5;
    ReferenceAssembly assembly(dense(), calm);
    assembly.step(Mat2::Zero(), dt, 20'000);
    const Mat2 s = assembly.stress();
    EXPECT_LT(std::abs(s(0, 1) - s(1, 0)), 1e-6 * s.trace());
}

TEST(ReferenceAssembly, ConservesMomentumWithoutDamping) {
    Material material;
    material.damping = 0;
    ReferenceAssembly assembly(dense(), material);
    assembly.step(Mat2::Zero(), dt, 500);
    const Packing p = assembly.packing();
    Vec2 momentum = Vec2::Zero();
    double scale = 0;
    for (std::size_t g = 0; g < p.size(); ++g) {
        momentum += p.r[g] * p.r[g] * Vec2(p.vx[g], p.vy[g]);
        scale += p.r[g] * p.r[g] * std::hypot(p.vx[g], p.vy[g]);
    }
    ASSERT_GT(scale, 0);
    EXPECT_LT(momentum.norm(), 1e-12 * scale);
}

TEST(ReferenceAssembly, GoesOnFromItsOwnPacking) {
    ReferenceAssembly whole(dense(), Material{});
    whole.step(gradient(0, 1, 0, 0), dt, 300);
    ReferenceAssembly rest(whole.packing(), Material{});
    whole.step(gradient(0, 1, 0, 0), dt, 50);
    rest.step(gradient(0, 1, 0, 0), dt, 50);
    EXPECT_LT(relative(rest.stress(), whole.stress()), 1e-8);
    EXPECT_EQ(rest.cell(), whole.cell());
}

TEST(ReferenceAssembly, ContactsVanishWithTheLastOverlap) {
    ReferenceAssembly assembly(dense(), Material{});
    assembly.step(gradient(2, 0, 0, 2), dt, 5'000);
    EXPECT_EQ(assembly.observe().contacts, 0);
    EXPECT_EQ(assembly.stress(), Mat2(Mat2::Zero()));
}

TEST(ReferenceAssembly, TensionNeverArises) {
    ReferenceAssembly assembly(dense(), Material{});
    std::size_t seen = 0;
    for (int k = 0; k < 20; ++k) {
        assembly.step(gradient(0.1, 2, 0, 0.1), dt, 200);
        const auto contacts = assembly.contacts();
        for (const ContactForce& c : contacts) ASSERT_GE(c.f_n, 0);
        seen += contacts.size();
    }
    EXPECT_GT(seen, 1000u);
}

TEST(ReferenceAssembly, FrictionBoundsEveryTangentialForce) {
    ReferenceAssembly assembly(dense(), Material{});
    assembly.step(gradient(0.2, 0, 0, -0.2), dt, 2'000);
    for (const double tan_phi : {std::tan(Material{}.friction_angle), 0.1}) {
        assembly.set_friction(tan_phi);
        assembly.step(Mat2::Zero(), dt, 1);
        int sliding = 0;
        for (const ContactForce& c : assembly.contacts()) {
            EXPECT_LE(c.f_t.norm(), tan_phi * c.f_n * (1 + 1e-12));
            EXPECT_LE(std::abs(c.moment), 0.05 * 0.007 * c.f_n);
            sliding += c.f_t.norm() > tan_phi * c.f_n * (1 - 1e-9);
        }
        EXPECT_GT(sliding, 10);
    }
}

TEST(ReferenceAssembly, ShearsTo300PercentWithoutLosingContacts) {
    ReferenceAssembly assembly(dense(), Material{});
    assembly.step(gradient(0, 20, 0, 0), dt, 15'000);
    const Observables seen = assembly.observe();
    EXPECT_NEAR(assembly.cell()(0, 1) / assembly.cell()(1, 1), 3, 0.01);
    // Contacts found afresh among all images are those the assembly kept.
    const Packing p = assembly.packing();
    EXPECT_NEAR(static_cast<double>(contact_forces(p, Material{}).size()), seen.contacts,
                0.02 * seen.contacts);
    EXPECT_GT(seen.contacts, 400);
}

}  // namespace
}  // namespace sandgraph::dem

#include <gtest/gtest.h>

#include "dem/reference/reference.hpp"
#include "yade_reference.hpp"

namespace sandgraph::dem {
namespace {

constexpr double dt_prescribed = 1e-5, dt_free = 2e-6;

// Largest force difference [N] and scaled moment difference over the whole prescribed motion.
double worst_prescribed(const std::string& file, RollingForm form) {
    const test::Table t = test::read_table(file);
    Material material;
    material.rolling_form = form;
    const PairConstants constants(0.005, 0.003, material);
    ContactState contact;
    double worst = 0, before = 0;
    for (std::size_t k = 0; k < t.rows.size(); ++k) {
        // The prescribed spin acts at once in the increments, but turns the disks only at the end of the
        // step.
        const double turn = (t.at(k, "w1") - t.at(k, "w0")) * dt_prescribed;
        const PairMotion motion{Vec2(t.at(k, "x1") - t.at(k, "x0"), t.at(k, "y1") - t.at(k, "y0")),
                                Vec2(t.at(k, "vx1") - t.at(k, "vx0"), t.at(k, "vy1") - t.at(k, "vy0")),
                                t.at(k, "w0"), t.at(k, "w1"), form == RollingForm::total ? before : turn};
        before = turn;
        const bool touches =
            advance(contact, constants, motion, std::tan(material.friction_angle), form, dt_prescribed);
        EXPECT_EQ(touches, t.at(k, "contact") == 1) << "step " << k + 1;
        worst =
            std::max({worst, std::abs(contact.f_n - t.at(k, "fn")),
                      std::abs(contact.f_t.x() - t.at(k, "ftx")), std::abs(contact.f_t.y() - t.at(k, "fty")),
                      std::abs(contact.moment - t.at(k, "mz")) / constants.r_j});
    }
    return worst;
}

Packing two_free_disks(const test::Table& t) {
    Packing p;
    p.H = Mat2::Identity();  // 1 m: no image is near
    p.r = {0.005, 0.004};
    p.x = {t.at(0, "x0"), t.at(0, "x1")}, p.y = {t.at(0, "y0"), t.at(0, "y1")};
    p.vx = {t.at(0, "vx0"), t.at(0, "vx1")}, p.vy = {t.at(0, "vy0"), t.at(0, "vy1")};
    p.spin = {t.at(0, "w0"), t.at(0, "w1")};
    return p;
}

double force_error(const std::vector<ContactForce>& contacts, const test::Table& t, std::size_t k) {
    EXPECT_EQ(contacts.size(), t.at(k, "contact")) << "step " << k + 1;
    if (contacts.empty()) return 0;
    const ContactForce& c = contacts.front();
    return std::max({std::abs(c.f_n - t.at(k, "fn")), std::abs(c.f_t.x() - t.at(k, "ftx")),
                     std::abs(c.f_t.y() - t.at(k, "fty")), std::abs(c.moment - t.at(k, "mz")) / 0.004});
}

double worst_free(const std::string& file, double damping) {
    const test::Table t = test::read_table(file);
    Material material;
    material.damping = damping;
    ReferenceAssembly assembly(two_free_disks(t), material);
    double worst = 0;
    for (std::size_t k = 0; k < t.rows.size(); ++k) {
        assembly.step(Mat2::Zero(), dt_free, 1);
        worst = std::max(worst, force_error(assembly.contacts(), t, k));
    }
    return worst;
}

TEST(ContactLaw, FollowsYadeThroughPrescribedMotionIncremental) {
    EXPECT_LT(worst_prescribed("twopart_kinematic_incremental.csv", RollingForm::incremental), 5e-12);
}

TEST(ContactLaw, FollowsYadeThroughPrescribedMotionTotal) {
    EXPECT_LT(worst_prescribed("twopart_kinematic_total.csv", RollingForm::total), 5e-12);
}

TEST(ContactLaw, RollingFormsDifferOnReversal) {
    EXPECT_GT(worst_prescribed("twopart_kinematic_total.csv", RollingForm::incremental), 1e-3);
}

TEST(ReferenceAssembly, FollowsYadeThroughAFreeCollision) {
    EXPECT_LT(worst_free("twopart_free_damp0.csv", 0), 5e-12);
}

TEST(ReferenceAssembly, FollowsYadeThroughADampedFreeCollision) {
    EXPECT_LT(worst_free("twopart_free_damp0.1.csv", 0.1), 5e-12);
}

TEST(ReferenceAssembly, ConservesMomentumInAFreeCollision) {
    const test::Table t = test::read_table("twopart_free_damp0.csv");
    Material material;
    material.damping = 0;
    ReferenceAssembly assembly(two_free_disks(t), material);
    const auto momentum = [&](const Packing& p) {
        return Vec2(25 * p.vx[0] + 16 * p.vx[1], 25 * p.vy[0] + 16 * p.vy[1]);  // masses go with r^2
    };
    const Vec2 before = momentum(assembly.packing());
    assembly.step(Mat2::Zero(), dt_free, 300);
    EXPECT_LT((momentum(assembly.packing()) - before).norm(), 1e-13);
}

}  // namespace
}  // namespace sandgraph::dem

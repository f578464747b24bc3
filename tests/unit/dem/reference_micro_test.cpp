#include <gtest/gtest.h>

#include "dem/packing/csv.hpp"
#include "dem/reference/reference.hpp"
#include "yade_reference.hpp"

namespace sandgraph::dem {
namespace {

// Simple shear L_xy = 1 /s of the dense packing from rest, every grain and contact compared with YADE.
const Mat2 shear = (Mat2() << 0, 1, 0, 0).finished();
constexpr double dt = 1e-5, r_mean = 0.005;

class MicroCase : public testing::Test {
  protected:
    MicroCase() : assembly(read_packing_csv(test::yade_file("packing_dense_p32.csv")), Material{}) {}
    void run_to(int target) { assembly.step(shear, dt, target - at), at = target; }

    // Largest distance to YADE's grains after `step` [mean radii].
    double position_error(int step) {
        static const test::Table t = test::read_table("micro_dense_particles.csv");
        const Packing p = assembly.packing();
        double worst = 0;
        std::size_t rows = 0;
        for (std::size_t k = 0; k < t.rows.size(); ++k) {
            if (t.at(k, "step") != step) continue;
            ++rows;
            const auto g = static_cast<std::size_t>(t.at(k, "id"));
            worst = std::max(worst, std::hypot(p.x[g] - t.at(k, "x"), p.y[g] - t.at(k, "y")) / r_mean);
        }
        EXPECT_EQ(rows, p.size());
        return worst;
    }
    double contact_error(int step);

    ReferenceAssembly assembly;
    int at = 0;
};

const ContactForce* find(const std::vector<ContactForce>& contacts, int i, int j) {
    for (const ContactForce& c : contacts)
        if (c.i == i && c.j == j) return &c;
    return nullptr;
}

// Largest force difference [N]; counts missing contacts as failures.
double MicroCase::contact_error(int step) {
    static const test::Table t = test::read_table("micro_dense_contacts.csv");
    const std::vector<ContactForce> contacts = assembly.contacts();
    double worst = 0;
    std::size_t rows = 0;
    for (std::size_t k = 0; k < t.rows.size(); ++k) {
        if (t.at(k, "step") != step) continue;
        ++rows;
        const bool swapped = t.at(k, "id1") > t.at(k, "id2");
        const int a = static_cast<int>(t.at(k, "id1")), b = static_cast<int>(t.at(k, "id2"));
        const ContactForce* c = find(contacts, std::min(a, b), std::max(a, b));
        if (c == nullptr) return ADD_FAILURE() << "no contact " << a << ' ' << b, 1e9;
        const double sign = swapped ? -1 : 1;
        const Vec2 f_t = sign * c->f_t - Vec2(t.at(k, "ftx"), t.at(k, "fty"));
        worst = std::max({worst, std::abs(c->f_n - t.at(k, "fn")), f_t.norm(),
                          std::abs(sign * c->moment - t.at(k, "mz")) / r_mean});
    }
    EXPECT_EQ(contacts.size(), rows);
    return worst;
}

TEST_F(MicroCase, PositionsAreYadesToRoundOffThenToTheNaturalDivergence) {
    run_to(1);
    EXPECT_LT(position_error(1), 2e-15);
    run_to(10);
    EXPECT_LT(position_error(10), 2e-14);
    run_to(100);
    EXPECT_LT(position_error(100), 1.5e-13);
    run_to(1000);
    EXPECT_LT(position_error(1000), 1e-8);
}

TEST_F(MicroCase, ContactForcesAreYades) {
    run_to(1);
    EXPECT_LT(contact_error(1), 1e-9);
    run_to(100);
    EXPECT_LT(contact_error(100), 1e-8);
    run_to(1000);
    EXPECT_LT(contact_error(1000), 1e-3);
}

TEST_F(MicroCase, StressAndEnergiesAreYades) {
    const test::Table t = test::read_table("micro_dense_stress.csv");
    for (std::size_t k = 0; k < t.rows.size() && t.at(k, "step") <= 100; ++k) {
        run_to(static_cast<int>(t.at(k, "step")));
        const Observables seen = assembly.observe();
        EXPECT_LT((assembly.stress() - t.tensor(k, "s")).cwiseAbs().maxCoeff(), 1e-6) << "step " << at;
        EXPECT_LT((assembly.cell() - t.tensor(k, "h")).cwiseAbs().maxCoeff(), 1e-12);
        EXPECT_NEAR(seen.kinetic_translation, t.at(k, "E_k_trans"), 1e-9 * t.at(k, "E_k_trans"))
            << "step " << at;
        EXPECT_NEAR(seen.kinetic_rotation, t.at(k, "E_k_rot"), 1e-9 * t.at(k, "E_k_rot")) << "step " << at;
    }
}

TEST_F(MicroCase, RepeatsItselfBitForBit) {
    run_to(500);
    ReferenceAssembly again(read_packing_csv(test::yade_file("packing_dense_p32.csv")), Material{});
    for (int k = 0; k < 50; ++k) again.step(shear, dt, 10);
    EXPECT_EQ(assembly.packing().x, again.packing().x);
    EXPECT_EQ(assembly.stress(), again.stress());
}

}  // namespace
}  // namespace sandgraph::dem

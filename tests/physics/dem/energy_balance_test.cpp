#include "dissipation.hpp"

namespace sandgraph::dem {
namespace {

using test::KernelKind, test::matrix;

Material undamped() {
    Material material;
    material.damping = 0;
    return material;
}
// No tangential force, no moment: only normal springs.
Material frictionless() {
    Material material = undamped();
    material.friction_angle = 0, material.rolling_limit = 0;
    return material;
}
// Neither slips nor rolls off: all springs, nothing dissipates.
Material sticking() {
    Material material = undamped();
    material.friction_angle = 1.57, material.rolling_limit = 1e6;
    return material;
}

struct Energy {
    double stored = 0, kinetic = 0;
};

// Books of a strain path. Boundary work on the packing: dW = -h A sigma_ab L_ba dt, stress compression
// positive; both the work and the energies count from the first evaluation.
class EnergyBooks {
  public:
    EnergyBooks(Assembly& sample, const Material& material) : sample_(sample), depth_(material.depth) {}

    void follow(const Mat2& L, int steps) {
        for (int k = 0; k < steps; ++k) {
            // The step evaluates the forces at the end of the motion under the L before.
            sample_.step(L, test::dt, 1);
            const double power = -depth_ * sample_.cell().determinant() * (sample_.stress() * L).trace();
            if (started_) work_ += 0.5 * test::dt * (power + power_);
            power_ = power;
            if (!started_) start_ = energy(), started_ = true;
        }
    }
    double work() const { return work_; }
    double stored() { return energy().stored - start_.stored; }
    double kinetic() { return energy().kinetic - start_.kinetic; }
    double dissipated() { return work_ - stored() - kinetic(); }

  private:
    Energy energy() {
        const Observables o = sample_.observe();
        return {o.elastic_normal + o.elastic_tangential + o.elastic_rolling,
                o.kinetic_translation + o.kinetic_rotation};
    }
    Assembly& sample_;
    double depth_, work_ = 0, power_ = 0;
    Energy start_;
    bool started_ = false;
};

class EnergyBalance : public testing::TestWithParam<KernelKind> {
  protected:
    // The dense packing of `material`, at rest.
    std::unique_ptr<Assembly> rest(const Material& material) const {
        return test::assembly(GetParam(), test::resting("dense", material), material);
    }
};

TEST_P(EnergyBalance, WorkOnFrictionlessGrainsIsStoredOrMoves) {
    const auto sample = rest(frictionless());
    EnergyBooks books(*sample, frictionless());
    books.follow(matrix(-0.1, 0, 0, -0.1), 2000);  // to 0.2 % isotropic
    books.follow(matrix(0.05, 0, 0, -0.05), 1000);
    EXPECT_GT(books.work(), 0);
    EXPECT_NEAR(books.stored() + books.kinetic(), books.work(), 0.01 * books.work());
    RecordProperty("share_lost", std::to_string(books.dissipated() / books.work()));
}

TEST_P(EnergyBalance, WorkOnStickingGrainsIsStoredOrMoves) {
    const auto sample = rest(sticking());
    EnergyBooks books(*sample, sticking());
    books.follow(matrix(-0.02, 0, 0, -0.1), 500);  // to 0.05 %
    EXPECT_GT(books.work(), 0);
    EXPECT_NEAR(books.stored() + books.kinetic(), books.work(), 0.01 * books.work());
    RecordProperty("share_lost", std::to_string(books.dissipated() / books.work()));
}

TEST_P(EnergyBalance, FrictionAndDampingOnlyTake) {
    for (const Material& material : {undamped(), Material{}}) {
        const auto sample = rest(material);
        EnergyBooks books(*sample, material);
        double taken = 0, work = 0;
        for (int part = 0; part < 20; ++part) {  // to 2 % isochoric
            books.follow(matrix(0.1, 0, 0, -0.1), 1000);
            EXPECT_GE(books.dissipated() - taken, -1e-3 * (books.work() - work)) << "part " << part;
            taken = books.dissipated(), work = books.work();
        }
        EXPECT_GT(taken, 0.2 * work);  // most of the work of a yielding sand is heat
        EXPECT_LT(taken, work);
    }
}

// Boundary work = stored + kinetic + heat, the heat counted contact by contact and grain by grain.
TEST_P(EnergyBalance, WorkOnYieldingSandIsStoredMovesOrBecomesHeat) {
    const Material material;
    const auto sample = rest(material);
    EnergyBooks books(*sample, material);
    test::Dissipation heat(material);
    const Mat2 L = matrix(0.5, 0, 0, -0.5);
    books.follow(L, 2);
    const double before = books.work() - books.stored() - books.kinetic();
    test::Instant last(*sample);
    for (int step = 0; step < 4000; ++step) {  // to 2 % isochoric
        books.follow(L, 1);
        test::Instant now(*sample);
        heat.step(last, now, L);
        last = std::move(now);
    }
    RecordProperty("share_open", std::to_string((books.dissipated() - before - heat.sum()) / books.work()));
    EXPECT_NEAR(books.dissipated() - before, heat.sum(), 0.01 * books.work());
    EXPECT_GT(heat.sliding, 0.2 * books.work());
    EXPECT_GT(heat.damping, 0);
}

INSTANTIATE_TEST_SUITE_P(Kernel, EnergyBalance,
                         testing::Values(KernelKind::reference, KernelKind::fast, KernelKind::mixed),
                         test::name_of);

}  // namespace
}  // namespace sandgraph::dem

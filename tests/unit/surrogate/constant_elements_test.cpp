#include <gtest/gtest.h>

#include "stress/increment.hpp"
#include "surrogate/serving.hpp"
#include "tests/unit/surrogate/driver.hpp"

namespace sandgraph::surrogate {
namespace {

// Constant coefficients, no dilation: exact solutions exist.
Model constant_model() {
    Model model = support::random_model(3, {1, 8, 0, 0});
    model.members[0].exponent = 0;
    model.members[0].critical.mature = 1e9;  // never comes of age
    for (double& d : model.members[0].dilatancy) d = 0;
    return model;
}

const Stress isotropic{-2e4, -2e4, 0};

Mat2 shear_at_constant_volume(double e) { return (Mat2() << std::exp(e), 0, 0, std::exp(-e)).finished(); }
double half_difference(const Stress& s) { return 0.5 * (s.xx - s.yy); }

// Stress after `steps` increments of shear e.
double drive_shear(Driver& point, double e, int steps) {
    Stress s;
    for (int i = 0; i < steps; ++i) s = point.drive(shear_at_constant_volume(e)).stress;
    return half_difference(s);
}

TEST(ConstantElements, UnloadingFollowsMasingsRule) {
    const Serving law(constant_model());
    Driver backbone(law, isotropic), point(law, isotropic);
    const double reversal = drive_shear(point, 2e-5, 100);
    for (int i = 0; i < 10; ++i) {
        const double half = drive_shear(backbone, 1e-5, 10);
        EXPECT_NEAR(drive_shear(point, -2e-5, 10), reversal - 2 * half, 1e-9 * 2e4);
    }
}

TEST(ConstantElements, HysteresisLoopCloses) {
    const Serving law(constant_model());
    Driver point(law, isotropic);
    const double top = drive_shear(point, 2e-5, 100);
    EXPECT_NEAR(drive_shear(point, -2e-5, 200), -top, 1e-9 * 2e4);
    EXPECT_NEAR(drive_shear(point, 2e-5, 200), top, 1e-9 * 2e4);
    // A small loop inside is forgotten when it is passed.
    drive_shear(point, -2e-5, 50);
    drive_shear(point, 2e-5, 30);
    drive_shear(point, -2e-5, 30);
    EXPECT_NEAR(drive_shear(point, -2e-5, 150), -top, 1e-9 * 2e4);
}

TEST(ConstantElements, FrictionBoundsTheStressAndIsReached) {
    const Model model = constant_model();
    double limit = 0;
    for (const double r : model.members[0].strength) limit += r;
    const Serving law(model);
    Driver point(law, isotropic);
    for (const Mat2& F : random_path(8, 400, 1e-3)) {
        const Stress s = point.drive(F).stress;
        EXPECT_LE(deviator(s), limit * mean_stress(s) * (1 + 1e-12));
    }
    Driver onward(law, isotropic);
    Stress s;
    for (int i = 0; i < 300; ++i) s = onward.drive(shear_at_constant_volume(1e-3)).stress;
    EXPECT_NEAR(deviator(s) / mean_stress(s), limit, 1e-9);
}

// Elastic energy a volume [Pa]: p^2/(2 K) + sum |t_k|^2/(2 G_k).
double elastic_energy(const Model& model, const StateLayout& layout, const std::vector<double>& state) {
    const PointState point = unpack(layout, state);
    const MemberState& m = point.members[0];
    double energy = m.p * m.p / (2 * point.constants.bulk);
    for (std::size_t k = 0; k < model.elements; ++k)
        energy += std::norm(m.elements[k]) / (2 * point.constants.shear * model.members[0].share[k]);
    return energy;
}

TEST(ConstantElements, ClosedStrainCyclesNeverMakeEnergy) {
    const Model model = constant_model();
    const Reference law(model);
    Random random(5);
    for (int cycle = 0; cycle < 20; ++cycle) {
        Driver point(law, isotropic);
        const double start = elastic_energy(model, law.layout(), point.state());
        const double a = random.uniform(0, 5e-5), b = random.uniform(-1e-5, 1e-5);
        double work = 0;
        Stress before = isotropic;
        for (int i = 0; i < 400; ++i) {  // an ellipse in the plane of the deviators, with volume
            const double c = std::cos(i * M_PI / 200), s = std::sin(i * M_PI / 200);
            const Mat2 F = gradient(a * c + b * s, -a * c + b * s, 0.7 * a * s, 0.7 * a * s);
            const stress::Increment e = stress::increment(F);
            const Stress after = point.drive(F).stress;
            work += 0.5 * ((before.xx + after.xx) * e.xx + (before.yy + after.yy) * e.yy +
                           2 * (before.xy + after.xy) * e.xy);
            before = after;
            const double stored = elastic_energy(model, law.layout(), point.state()) - start;
            EXPECT_GE(work - stored, -1e-9 * start) << cycle << " " << i;
        }
    }
}

TEST(ConstantElements, TangentOfTheElasticRungIsItsModuli) {
    Model model = constant_model();
    model.frictional = false;
    const Serving law(model);
    const stress::PackingTraits traits = support::dense_traits();
    const double K = traits.bulk * model.members[0].bulk, G = traits.shear;
    Eigen::Matrix3d expected;
    expected << K + G, K - G, 0, K - G, K + G, 0, 0, 0, G;
    const Driver point(law);
    EXPECT_LT((law.tangent(point.state(), {1, 0, 0}) - expected).norm(), 1e-4 * K);
}

TEST(ConstantElements, SlippingElementHasNoStiffnessAgainstShear) {
    const Model model = constant_model();
    const Serving law(model);
    Driver point(law, isotropic);
    for (int i = 0; i < 300; ++i) point.drive(shear_at_constant_volume(1e-3));
    const Eigen::Vector3d onward(1, -1, 0);
    const double G = support::dense_traits().shear;
    EXPECT_LT((law.tangent(point.state(), onward) * onward).norm(), 1e-3 * G);
    EXPECT_NEAR((law.tangent(point.state(), -onward) * onward)[0], 2 * G, 0.9 * G);  // back: elastic again
}

TEST(LearnedElements, TangentIsTheSlopeOfTheUpdate) {
    const Model model = support::random_model(1);
    const Serving law(model);
    const Reference scalar(model);
    Driver path(law);
    for (const Mat2& F : random_path(12)) path.drive(F);
    const Eigen::Vector3d along(0.3, -1, 0.4);
    const Eigen::Vector3d base = 1e-5 * along.normalized();
    const auto stress_at = [&](const Eigen::Vector3d& e) {
        std::vector<double> state = path.state();
        const Mat2 F = gradient(e[0], e[1], 0.5 * e[2], 0.5 * e[2]);
        const std::int32_t point = 0;
        stress::SurrogateAnswer answer;
        scalar.update({&point, 1}, {&F, 1}, state, {&answer, 1});
        return Eigen::Vector3d(answer.stress.xx, answer.stress.yy, answer.stress.xy);
    };
    const stress::Tangent tangent = law.tangent(path.state(), along);
    for (int j = 0; j < 3; ++j) {
        const Eigen::Vector3d slope =
            (stress_at(base + 1e-8 * Eigen::Vector3d::Unit(j)) - stress_at(base)) / 1e-8;
        EXPECT_LT((tangent.col(j) - slope).norm(), 1e-2 * slope.norm());
    }
}

}  // namespace
}  // namespace sandgraph::surrogate

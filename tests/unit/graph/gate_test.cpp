#include "graph/screening/gate.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "graph/screening/acoustic.hpp"

namespace sandgraph::graph {
namespace {

GateView quiet() {
    GateView view;
    view.stress = {-1e4, -1e4, 0};
    view.peak_friction = 0.5;
    return view;
}

TEST(DeviatoricStrain, IsTheDifferenceOfThePrincipalLogarithms) {
    const double turn = 0.7;
    const Mat2 R = (Mat2() << std::cos(turn), -std::sin(turn), std::sin(turn), std::cos(turn)).finished();
    for (const double e : {1e-9, 1e-4, 0.5}) {
        const Mat2 U = (Mat2() << std::exp(e + 0.01), 0, 0, std::exp(-e + 0.01)).finished();
        EXPECT_NEAR(deviatoric_strain(R * U) / (2 * e), 1, 1e-5) << e;
    }
    EXPECT_EQ(deviatoric_strain(1.1 * Mat2::Identity()), 0);
}

TEST(Gate, LeavesAQuietPointAlone) { EXPECT_LT(judge(quiet(), {}).level, 0.02); }

TEST(Gate, NamesTheMeasureThatIsWorst) {
    GateSettings set;
    set.strain = 0.005, set.spread = 0.1;
    GateView view = quiet();
    view.F << 1.004, 0, 0, 1;
    EXPECT_EQ(judge(view, set).reason, Reason::strain);
    EXPECT_LT(judge(view, set).level, 1);
    view.spread = 0.2;
    EXPECT_EQ(judge(view, set).reason, Reason::spread);
    EXPECT_DOUBLE_EQ(judge(view, set).level, 2);
}

TEST(Gate, EachMeasurePassesAtItsThreshold) {
    GateSettings set;
    set.acoustic = 0;
    GateView ratio = quiet(), tension = quiet(), distance = quiet(), work = quiet(), acoustic = quiet();
    ratio.stress = {-1.6e4, -0.4e4, 0};
    EXPECT_EQ(judge(ratio, set).reason, Reason::stress_ratio);
    EXPECT_GE(judge(ratio, set).level, 1);
    tension.stress = {1, 1, 0};
    tension.peak_friction = 0;
    EXPECT_EQ(judge(tension, set).reason, Reason::tension);
    EXPECT_GE(judge(tension, set).level, 1);
    distance.distance = set.distance;
    EXPECT_EQ(judge(distance, set).reason, Reason::distance);
    work.work = set.second_order_work;
    EXPECT_DOUBLE_EQ(judge(work, set).level, 1);
    acoustic.acoustic = set.acoustic;
    EXPECT_DOUBLE_EQ(judge(acoustic, set).level, 1);
    GateSettings off;
    off.active = false;
    EXPECT_EQ(judge(tension, off).level, 0);
}

TEST(AcousticTensor, OfAnElasticBodyIsTheSameInAllDirections) {
    const double K = 2e7, G = 1.4e7;
    Eigen::Matrix3d C;
    C << K + G, K - G, 0, K - G, K + G, 0, 0, 0, G;
    EXPECT_NEAR(least_acoustic_determinant(C) / (G * (K + G)), 1, 1e-12);
}

TEST(AcousticTensor, LosesDefinitenessWhereShearSoftens) {
    Eigen::Matrix3d C;
    C << 3, 1, 0, 1, 3, 0, 0, 0, -0.1;  // shear modulus below zero in the axes of the grid
    EXPECT_LT(least_acoustic_determinant(C), 0);
}

}  // namespace
}  // namespace sandgraph::graph

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <numbers>

#include "graph/strain_path.hpp"
#include "tests/unit/graph/screening_bench.hpp"

// What laws of points measure and tell, against figures worked out beside them.
namespace sandgraph::graph {
namespace {

Mat2 of(double xx, double xy, double yx, double yy) { return (Mat2() << xx, xy, yx, yy).finished(); }

TEST(StrainNorm, IsTheFrobeniusNormOfTheHenckyStrain) {
    EXPECT_NEAR(strain_norm(of(std::exp(3e-3), 0, 0, std::exp(-4e-3))), 5e-3, 1e-8);
    EXPECT_NEAR(strain_norm(of(1, 2e-3, 2e-3, 1)), 2e-3 * std::numbers::sqrt2, 1e-8) << "shear twice";
    EXPECT_NEAR(strain_norm(of(1, 4e-3, 0, 1)), 2e-3 * std::numbers::sqrt2, 1e-8) << "half of it is spin";
    const double c = std::cos(0.4), s = std::sin(0.4);
    EXPECT_NEAR(strain_norm(of(c, -s, s, c)), 0, 1e-15);
}

TEST(StressNorm, CountsTheShearTwice) {
    EXPECT_DOUBLE_EQ(norm({3, 4, 0}), 5);
    EXPECT_DOUBLE_EQ(norm({0, 0, 5}), 5 * std::numbers::sqrt2);
    EXPECT_DOUBLE_EQ(norm(difference({1, 2, 3}, {4, 6, 3})), 5);
}

// Anticlockwise by w: R s R^T to first order.
TEST(Turn, FollowsTheSpinOfTheIncrement) {
    const double w = 1e-6;
    Stress s{-100, -300, 40};
    turn(s, of(1, -w, w, 1));
    EXPECT_NEAR((s.xx + 100) / w, -2 * 40, 1e-3);
    EXPECT_NEAR((s.yy + 300) / w, 2 * 40, 1e-3);
    EXPECT_NEAR((s.xy - 40) / w, -100 + 300, 1e-3);
    Stress sheared{-100, -300, 40};
    turn(sheared, of(1, w, w, 1));
    EXPECT_EQ(sheared, (Stress{-100, -300, 40})) << "symmetric shear does not turn";
}

TEST(ElasticChange, IsBulkOfTheVolumeAndTwiceShearOfTheDeviator) {
    const Stress d = elastic_change({5, 3}, of(1 + 0.02, 0.05, 0.01, 1 - 0.01));
    EXPECT_NEAR(d.xx, 5 * 0.01 + 3 * 0.03, 1e-15);
    EXPECT_NEAR(d.yy, 5 * 0.01 - 3 * 0.03, 1e-15);
    EXPECT_NEAR(d.xy, 2 * 3 * 0.03, 1e-15);
    EXPECT_EQ((PlaneModuli{5, 3}.p_wave()), 8);
}

// Of a prediction of 1 % of p that is exact, wrong by the tolerance, and badly wrong.
TEST(Visits, TheAdmissibleChangeFollowsTheErrorOfThePrediction) {
    const VisitSettings set{.update_tolerance = 0.0025, .update_change_max = 0.05};
    const PlaneModuli moduli{2e7, 1e7};
    const auto admissible = [&](double change, double error) {
        Visits visits(1);
        Stress s{-1e5, -1e5, 0};
        const auto step = [&](double share) {
            visits.predict(0, moduli,
                           of(1 + share * 1e5 / (2 * 1e7 * std::numbers::sqrt2), 0, 0,
                              1 - share * 1e5 / (2 * 1e7 * std::numbers::sqrt2)),
                           false, set, 1000, s);
        };
        step(change);
        visits.answered(0, 1e5, error, set);
        double sum = 0;
        do {
            step(1e-5), sum += 1e-5;
        } while (!visits.due(0));
        return sum;
    };
    EXPECT_NEAR(admissible(0.01, 0.0025), 0.9 * 0.01, 3e-5);
    EXPECT_NEAR(admissible(0.01, 0.01), 0.45 * 0.01, 3e-5);
    EXPECT_NEAR(admissible(0.01, 0), 2 * 0.01, 3e-5) << "twice at most";
    EXPECT_NEAR(admissible(0.01, 1), 0.25 * 0.01, 3e-5) << "a quarter at least";
    EXPECT_NEAR(admissible(0.04, 0), 0.05, 3e-5) << "never more than the largest change";
    EXPECT_NEAR(admissible(0.001, 1), 0.00125, 3e-5) << "half the tolerance at least";
}

TEST(Visits, AreDueAtTheToleranceOfThePressureOrOfTheFloor) {
    const VisitSettings set{.update_tolerance = 0.01};
    for (const double p : {1e5, 100.0}) {
        Visits visits(1);
        Stress s{-p, -p, 0};
        const double reference = std::max(p, 1000.0), norm_of_one = 2 * 1e7 * std::numbers::sqrt2;
        const double e = 0.0099 * reference / norm_of_one;
        visits.predict(0, {0, 1e7}, of(1 + e, 0, 0, 1 - e), false, set, 1000, s);
        EXPECT_FALSE(visits.due(0)) << p;
        visits.predict(0, {0, 1e7}, of(1 + 0.02 * e, 0, 0, 1 - 0.02 * e), false, set, 1000, s);
        EXPECT_TRUE(visits.due(0)) << p;
        EXPECT_TRUE(visits.answered(0, reference, 0, set)) << "the first step used a prediction";
        EXPECT_FALSE(visits.answered(0, reference, 0, set));
    }
}

TEST(Visits, OfAFloatingPointMoveNoStress) {
    Visits visits(1);
    Stress s;
    visits.predict(0, {1e7, 1e7}, of(1.001, 0, 0, 1.001), true, {}, 1000, s);
    EXPECT_EQ(s, Stress{});
    EXPECT_NEAR(visits.collected(0).determinant(), 1.001 * 1.001, 1e-12);
}

// Compressed and opened points, at visits and between them.
TEST(Observe, PorosityIsThatOfTheDeformationUpToNow) {
    ScreeningSetup setup = setup_of(3, 2e-3);
    auto bench = screening(3, setup);
    auto reference = full(3);
    std::vector<double> J(3, 1);
    for (int k = 0; k < 300; ++k) {
        for (std::size_t p = 0; p < 3; ++p) {
            bench.F[p] = of(1 + 5e-7 * double(p * p * p), 1e-6, 0, 1 - 2e-6 * double(p * p));
            reference.F[p] = bench.F[p], J[p] *= bench.F[p].determinant();
        }
        bench.law.update(bench.batch()), reference.law.update(reference.batch());
    }
    ASSERT_FALSE(bench.law.modes().by_grains(1));
    ASSERT_TRUE(bench.law.modes().by_grains(2));
    const double start = reference.law.rve(0).porosity();
    for (const std::size_t p : {0u, 1u}) {
        EXPECT_NEAR(bench.law.observe(p).porosity, 1 - (1 - 0.16) / J[p], 1e-9) << p;  // of its traits
        EXPECT_FALSE(bench.law.observe(p).by_grains);
    }
    EXPECT_GT(std::abs(J[2] - 1), 5e-4);
    EXPECT_NEAR(bench.law.observe(2).porosity, 1 - (1 - start) / J[2], 3e-5) << "along its recorded path";
    for (std::size_t p = 1; p < 3; ++p)
        EXPECT_NEAR(reference.law.observe(p).porosity, 1 - (1 - start) / J[p], 1e-9) << p;
}

// The last point is by grains, its second packing has stopped long ago: what it shows is of no meaning.
TEST(Audit, IsOfThePointsThatTheSurrogateAnswersFor) {
    ScreeningSetup setup = setup_of(4, 4e-3);
    setup.audit.share = 1;
    auto bench = screening(4, setup);
    shear(bench, 800);
    std::vector<double> errors;
    for (std::size_t p = 0; p < 4; ++p)
        if (!bench.law.modes().by_grains(p)) errors.push_back(bench.law.observe(p).audited_error);
    ASSERT_EQ(bench.law.modes().grain_points(), 2u);
    ASSERT_EQ(errors.size(), 2u);
    const AuditRow row = bench.law.audit();
    EXPECT_EQ(row.points, 2);
    EXPECT_EQ(row.population, 2);
    EXPECT_DOUBLE_EQ(row.mean, 0.5 * (errors[0] + errors[1]));
    EXPECT_EQ(row.ci95, 0) << "all of them were looked at";
}

// A plate's ground strains upwards as well as sideways: points in a column, every one at x = 0.
TEST(ScreeningLaw, NeighboursInHeightAreThoseWithinACellOnly) {
    auto bench = screening(6, setup_of(6, 2e-3));
    for (std::size_t p = 0; p < 6; ++p) bench.x[p] = 0, bench.y[p] = static_cast<double>(p);
    for (int k = 0; k < 400; ++k) {
        for (auto& F : bench.F) F = of(1 + 5e-7, 0, 0, 1 - 5e-7);
        bench.F[3] = of(1 + 5e-6, 0, 0, 1 - 5e-6);
        stress::Batch batch = bench.batch();
        batch.around = {bench.x, bench.y, bench.volume, 1, 1e-3 * k};
        bench.law.update(batch);
    }
    for (std::size_t p = 0; p < 6; ++p) EXPECT_EQ(bench.law.modes().by_grains(p), p >= 2 && p <= 4) << p;
}

}  // namespace
}  // namespace sandgraph::graph

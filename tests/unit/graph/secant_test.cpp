#include "graph/secant.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "graph/visits.hpp"
#include "tests/support/memory_archive.hpp"
#include "tests/unit/graph/screening_bench.hpp"

// Between two visits a point follows what its last answers fell short of the elastic stress, as long as it
// goes on the same way; and an update that a step cannot wait for is carried on into the next ones.
namespace sandgraph::graph {
namespace {

Mat2 of(double xx, double xy, double yx, double yy) { return (Mat2() << xx, xy, yx, yy).finished(); }
Mat2 biaxial(double e) { return of(1 + e, 0, 0, 1 - e); }
Mat2 shear(double e) { return of(1, e, e, 1); }

constexpr PlaneModuli kSand{.bulk = 30e6, .shear = 20e6};

TEST(Secants, OfAPathThatGoesOnGiveTheShortfallOfTheLastAnswer) {
    Secants secants(2);
    EXPECT_EQ(secants.shortfall(1, biaxial(1e-5)), Stress{}) << "nothing is known yet";
    secants.learn(1, biaxial(1e-5), {-100, 100, 0}, kSand);  // elastic: 100 too much along x
    EXPECT_NEAR(secants.shortfall(1, biaxial(3e-6)).xx, 30, 1e-9);
    EXPECT_NEAR(secants.shortfall(1, biaxial(3e-6)).yy, -30, 1e-9);
    EXPECT_EQ(secants.shortfall(0, biaxial(3e-6)), Stress{}) << "another point";
}

TEST(Secants, LeaveAnAnswerThatCameTrueWhereItIs) {
    Secants secants(1);
    secants.learn(0, biaxial(1e-5), {-100, 100, 0}, kSand);
    for (int visit = 0; visit < 5; ++visit) {
        const Stress predicted = secants.shortfall(0, biaxial(2e-5));
        EXPECT_NEAR(predicted.xx, 200, 1e-9) << visit;
        secants.learn(0, biaxial(2e-5), {}, kSand);
    }
}

TEST(Secants, TakeHalfOfWhatIsNew) {
    Secants secants(1);
    secants.learn(0, biaxial(1e-5), {-100, 100, 0}, kSand);
    secants.shortfall(0, biaxial(1e-5));
    secants.learn(0, biaxial(1e-5), {-100, 100, 0}, kSand);  // 200 in all where 100 were expected
    EXPECT_NEAR(secants.shortfall(0, biaxial(1e-5)).xx, 150, 1e-9);
}

TEST(Secants, OfAReversalAreElasticAndSoIsTheWayBack) {
    Secants secants(1);
    secants.learn(0, biaxial(1e-5), {-100, 100, 0}, kSand);
    EXPECT_EQ(secants.shortfall(0, biaxial(-1e-5)), Stress{});
    EXPECT_EQ(secants.shortfall(0, shear(1e-5)), Stress{}) << "across";
    EXPECT_EQ(secants.shortfall(0, biaxial(1e-5)), Stress{}) << "back to where it turned";
    EXPECT_NEAR(secants.shortfall(0, biaxial(1e-6)).xx, 10, 1e-9) << "further than ever";
}

TEST(Secants, OfAnotherWayStartAnew) {
    Secants secants(1);
    secants.learn(0, biaxial(1e-5), {-100, 100, 0}, kSand);
    secants.shortfall(0, biaxial(-1e-5));
    secants.learn(0, biaxial(-1e-5), {}, kSand);  // the elastic prediction was right
    EXPECT_NEAR(norm(secants.shortfall(0, biaxial(-1e-5))), 0, 1e-12) << "nothing is left of the way there";
}

TEST(Secants, LearnNothingFromAShake) {
    Secants secants(1);
    secants.learn(0, biaxial(1e-5), {-100, 100, 0}, kSand);
    secants.shortfall(0, biaxial(-1e-5)), secants.shortfall(0, biaxial(0.9e-5));
    secants.learn(0, biaxial(-1e-6), {-100, 100, 0}, kSand);  // a shortfall on a way ten times as short
    EXPECT_EQ(secants.shortfall(0, biaxial(-1e-6)), Stress{});
    secants.shortfall(0, biaxial(2e-6));
    EXPECT_NEAR(secants.shortfall(0, biaxial(1e-6)).xx, 10, 1e-9) << "what was known is still";
}

TEST(Secants, TakeNoMoreThanTheWholeStiffness) {
    Secants secants(1);
    secants.learn(0, biaxial(1e-5), {-1e4, 1e4, 0}, kSand);
    EXPECT_NEAR(secants.shortfall(0, biaxial(1e-6)).xx, 2 * kSand.shear * 1e-6, 1e-8)
        << "perfectly plastic: the stress stays, it does not fall";
}

// A point shaken to and fro, whatever its law answers: what it gives off is never more than it took.
TEST(Secants, GiveOffNoWorkWhenShaken) {
    Secants secants(1);
    secants.learn(0, biaxial(1e-5), {-300, 300, 0}, kSand);
    double work = 0;
    Stress s{};
    for (int k = 0; k < 4000; ++k) {
        const double e = 1e-7 * std::cos(0.01 * k);
        const Stress d = difference(elastic_change(kSand, biaxial(e)), secants.shortfall(0, biaxial(e)));
        work += (s.xx + 0.5 * d.xx) * e - (s.yy + 0.5 * d.yy) * e;
        add(s, d);
    }
    EXPECT_GE(work, 0);
}

TEST(Secants, CountTheShearOfBothSides) {
    Secants secants(1);
    secants.learn(0, shear(1e-5), {0, 0, -100}, kSand);
    EXPECT_NEAR(secants.shortfall(0, shear(1e-5)).xy, 100, 1e-9);
    EXPECT_NEAR(secants.shortfall(0, of(1, 2e-5, 0, 1)).xy, 100, 1e-9) << "simple shear is half of it";
}

RveLaw law_of(Predictor predictor, dem::RveOptions options = support::table1_options()) {
    VisitSettings visits;
    visits.predictor = predictor;
    return RveLaw({{}, options, {support::public_packing()}, {0}, visits});
}

// A packing on a plastic path: biaxial to 0.4 %, half way back, and on.
Bench<RveLaw> along_plastic_path(Predictor predictor, int steps) {
    Bench<RveLaw> bench{1, law_of(predictor)};
    for (int k = 0; k < steps; ++k) {
        bench.F[0] = biaxial(k > 2000 && k <= 3000 ? -2e-6 : 2e-6);
        bench.law.update(bench.batch());
    }
    return bench;
}

TEST(Secants, FollowAPlasticPathBetterThanTheElasticStiffness) {
    const auto secant = along_plastic_path(Predictor::secant, 2000),
               elastic = along_plastic_path(Predictor::elastic, 2000);
    const RveCounters &s = secant.law.counters(), &e = elastic.law.counters();
    EXPECT_LT(s.updates, 0.7 * double(e.updates)) << "fewer visits ...";
    EXPECT_LT(s.prediction_error_sum / double(s.predicted),
              1.2 * e.prediction_error_sum / double(e.predicted))
        << "... at the same error";
    EXPECT_LT(share(secant.stress[0], elastic.stress[0]), 0.02);
}

// Everything that a law remembers.
dem::RveOptions everything_on() {
    dem::RveOptions options = support::table1_options();
    options.steps_max = 5, options.steady_factor = 2, options.steady_strain = 5e-4, options.rate_jump_max = 2;
    return options;
}

void shear_on(Bench<RveLaw>& bench, int from, int to) {
    for (int k = from; k < to; ++k) {
        bench.F[0] = k % 40 == 7 ? biaxial(3e-4) : shear(k > 150 ? -4e-6 : 4e-6);
        bench.law.update(bench.batch());
    }
}

TEST(RveLaw, WithAllItsRulesGoesOnFromAnArchiveBitForBit) {
    for (const int at : {48, 101, 163}) {  // 48, 101: soon after a long increment, whose update goes on
        Bench<RveLaw> whole{1, law_of(Predictor::secant, everything_on())};
        shear_on(whole, 0, at);
        support::MemoryArchive memory;
        whole.law.archive(memory);
        Bench<RveLaw> resumed{1, law_of(Predictor::secant, everything_on())};
        memory.read_from_now_on();
        resumed.law.archive(memory);
        resumed.stress = whole.stress;
        shear_on(whole, at, 240), shear_on(resumed, at, 240);
        EXPECT_EQ(whole.stress, resumed.stress) << at;
        EXPECT_EQ(whole.law.counters().dem_steps, resumed.law.counters().dem_steps) << at;
    }
}

TEST(RveLaw, NoUpdateTakesMoreStepsThanItMayAndTheRestFollows) {
    dem::RveOptions unbounded = support::table1_options(), bounded;
    unbounded.inertial_number_max = 1;
    bounded = unbounded, bounded.steps_max = 20;
    Bench<RveLaw> capped{1, law_of(Predictor::elastic, bounded)},
        free{1, law_of(Predictor::elastic, unbounded)};
    int longest = 0, steps = 0;
    const auto step = [&](const Mat2& F) {
        for (auto* bench : {&capped, &free}) {
            bench->F[0] = F;
            bench->law.update(bench->batch());
        }
        for (const RveAnswer& a : capped.law.last_answers()) longest = std::max(longest, a.report.dem_steps);
    };
    step(biaxial(1e-3));
    EXPECT_GT(free.law.counters().dem_steps, 100);
    EXPECT_NEAR(capped.law.observe(0).porosity, free.law.observe(0).porosity, 1e-12)
        << "what is not driven yet is seen";
    for (; capped.law.last_answers().size() > 0 && steps < 50; ++steps) step(Mat2::Identity());
    EXPECT_EQ(longest, 20);
    EXPECT_EQ(steps, 8);  // 142 steps of 1e-5, 20 at once; none is due in the last
    EXPECT_LT(share(capped.stress[0], free.stress[0]), 0.01);
    EXPECT_EQ(capped.law.counters().predicted, 1) << "one answer, whose prediction the ground has used";
}

}  // namespace
}  // namespace sandgraph::graph

#include "graph/screening/auditors.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

#include "tests/support/memory_archive.hpp"
#include "tests/support/packing_surrogate.hpp"
#include "tests/unit/graph/screening_bench.hpp"

// What auditors say of the load's error, in ground whose error is known.
namespace sandgraph::graph {
namespace {

ScreeningSetup audited(std::size_t points, int expected, double stronger = 1) {
    ScreeningSetup setup = setup_of(points, 1);
    setup.surrogate = std::make_shared<support::PackingSurrogate>(stronger);
    setup.gate.active = false;
    setup.audit.load_points = expected;
    return setup;
}

// Points are sheared the more the higher their id; the plate goes on `by` so much d/B in a step. Returns the
// work that the ground has taken.
double pull(Bench<ScreeningLaw>& b, int steps, double from = 0, double by = 0) {
    double work = 0;
    for (std::size_t p = 0; p < b.F.size(); ++p) {
        const double e = 4e-6 * static_cast<double>(p + 1) / static_cast<double>(b.F.size());
        b.F[p] << 1 + e, 0, 0, 1 - e;
    }
    for (int k = 0; k < steps; ++k) {
        stress::Batch batch = b.batch();
        batch.around = {b.x, b.y, b.volume, 1, from + by * k};
        b.law.update(batch);
        for (std::size_t p = 0; p < b.F.size(); ++p) work += product(b.stress[p], small_strain(b.F[p]));
    }
    return work;
}

TEST(Auditors, OfASurrogateThatIsItsPackingsFindNothing) {
    auto bench = screening(4, audited(4, 40));
    const double work = pull(bench, 1500);
    const stress::VirtualWork w = bench.law.take_missing_work();
    EXPECT_GT(work, 0);
    EXPECT_LT(std::abs(w.missing), 0.02 * work);
    EXPECT_EQ(w.variance, 0);  // all points audit
}

// Deviators 1.25 times those of the grains: the grains take a fifth less work.
TEST(Auditors, OfABiasedSurrogateFindItsBias) {
    auto bench = screening(4, audited(4, 40, 1.25));
    const double work = pull(bench, 1500);
    EXPECT_NEAR(bench.law.take_missing_work().missing / work, -0.2, 0.02);
}

TEST(Auditors, OfWhichOnlySomeAreDrawnFindTheBiasWithinTheirInterval) {
    double missing = 0, variance = 0, work = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        ScreeningSetup setup = audited(12, 5, 1.25);
        setup.audit.seed = seed;
        auto bench = screening(12, setup);
        work += pull(bench, 400);
        EXPECT_LT(bench.law.auditors().measuring(), 12u);
        const stress::VirtualWork w = bench.law.take_missing_work();
        EXPECT_GT(w.variance, 0);
        missing += w.missing, variance += w.variance;
    }
    EXPECT_NEAR(missing, -0.2 * work, 2 * std::sqrt(variance) + 0.02 * work);
    EXPECT_LT(std::sqrt(variance), 0.2 * work);
}

TEST(Auditors, TakenWorkIsThatSinceItWasLastTaken) {
    auto bench = screening(2, audited(2, 40, 1.25));
    pull(bench, 200);
    EXPECT_NE(bench.law.take_missing_work().missing, 0);
    EXPECT_EQ(bench.law.take_missing_work().missing, 0);
}

// Sheared at a constant volume grains press; the ground of ElementSurrogate does not.
TEST(Auditors, GiveWayUntilTheirMeanStressIsTheGrounds) {
    ScreeningSetup setup = setup_of(2, 1);
    setup.gate.active = false;
    setup.audit.load_points = 40, setup.audit.share = 1;
    auto bench = screening(2, setup);
    pull(bench, 3000);  // point 1 to a strain of 2.4e-2
    const double p = mean_stress(bench.stress[1]);
    EXPECT_GT(std::abs(mean_stress(tension_positive(bench.law.observe(1).packing->stress())) - p), 0.2 * p);
    EXPECT_LT(std::abs(mean_stress(bench.law.auditors().shortfall(1))), 0.05 * p);
}

TEST(Auditors, MoveNoBitOfTheGround) {
    ScreeningSetup looked = setup_of(4, 3e-3), alone = looked;
    looked.audit.load_points = 40, alone.audit.load_points = 0;
    auto a = screening(4, looked), b = screening(4, alone);
    shear(a, 700), shear(b, 700);
    EXPECT_EQ(a.stress, b.stress);
    EXPECT_GT(a.law.screening_log()->counters.load_audit_steps, 0);
    EXPECT_EQ(b.law.screening_log()->counters.load_audit_steps, 0);
    EXPECT_TRUE(a.law.audits_load());
    EXPECT_FALSE(b.law.audits_load());
}

// A sample of two of twelve is drawn anew as the plate goes on; who joins late has gone its point's way.
TEST(Auditors, DrawnLateStandWhereTheyWouldHaveStood) {
    ScreeningSetup few = setup_of(12, 1), all = few;
    few.gate.active = all.gate.active = false;
    few.audit.load_points = 2, few.audit.load_evenly = 0.05, all.audit.load_points = 100;
    auto drawn = screening(12, few), census = screening(12, all);
    std::vector<std::uint8_t> measured(12, 0);
    int late = 0;
    for (int k = 0; k < 20; ++k) {
        pull(drawn, 100, 0.01 * k, 1e-4), pull(census, 100, 0.01 * k, 1e-4);
        for (std::int32_t p = 0; p < 12; ++p) {
            if (drawn.law.auditors().chance(p) == 0) continue;
            const bool joined = k > 0 && !measured[static_cast<std::size_t>(p)]++;
            if (!joined) continue;
            ++late;
            const Stress a = drawn.law.auditors().shortfall(p), b = census.law.auditors().shortfall(p);
            EXPECT_LT(norm(difference(a, b)), 0.1 * mean_stress(drawn.stress[static_cast<std::size_t>(p)]))
                << p;
        }
    }
    EXPECT_GT(late, 0);
}

TEST(Auditors, HaveNothingToSayWhereGrainsAnswer) {
    ScreeningSetup setup = setup_of(3, 0);
    setup.audit.load_points = 40;
    auto bench = screening(3, setup);
    shear(bench, 300);
    EXPECT_EQ(bench.law.auditors().measuring(), 0u);
    EXPECT_EQ(bench.law.take_missing_work().missing, 0);
}

ScreeningSetup redrawn() {
    ScreeningSetup setup = setup_of(12, 6e-3);
    setup.audit.load_points = 4, setup.gate.flow = 1e-2;
    return setup;
}

TEST(Auditors, SayTheSameOnAnyNumberOfThreads) {
    const auto missing = [](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        auto bench = screening(12, redrawn());
        pull(bench, 1200, 0, 1e-5);
        const stress::VirtualWork w = bench.law.take_missing_work();
        return std::pair(w.missing, w.variance);
    };
    const auto one = missing(1);
    EXPECT_NE(one.first, 0);
    EXPECT_EQ(one, missing(2));
}

TEST(Auditors, GoOnFromAnArchiveBitForBit) {
    auto begun = screening(12, redrawn()), resumed = screening(12, redrawn());
    pull(begun, 500, 0, 1e-5);
    support::MemoryArchive memory;
    begun.law.archive(memory);
    memory.read_from_now_on();
    resumed.law.archive(memory);
    resumed.stress = begun.stress;
    pull(begun, 700, 0.005, 1e-5), pull(resumed, 700, 0.005, 1e-5);
    const auto a = begun.law.take_missing_work(), b = resumed.law.take_missing_work();
    EXPECT_NE(a.missing, 0);
    EXPECT_EQ(begun.stress, resumed.stress);
    EXPECT_EQ(a.variance, b.variance);
    EXPECT_EQ(a.missing, b.missing);
}

}  // namespace
}  // namespace sandgraph::graph

#include <gtest/gtest.h>

#include "tests/unit/graph/screening_stages.hpp"

// The stage of hand_over that looks at the gate's verdicts: who is made ready, who asks for the grains, and
// who goes with them.
namespace sandgraph::graph {
namespace {

constexpr Verdict kPast{1.2, Reason::strain}, kAtIt{1, Reason::spread}, kNear{0.5, Reason::strain},
    kQuiet{0.49, Reason::strain};

std::vector<std::size_t> neighbours(const ScreeningStages& s) {
    std::vector<std::size_t> out;
    for (std::size_t p = 0; p < s.modes.size(); ++p)
        if (s.modes.reason(p) == Reason::neighbour) out.push_back(p);
    return out;
}

TEST(Raise, FromTheLowThresholdOnAPackingIsMadeReadyAndAtTheHighOneThePointAsks) {
    ScreeningSetup setup = setup_of(1, 1);
    setup.gate.low = 0.5, setup.hand_over.dilate = 0;
    ScreeningStages s(4, setup);
    s.judged({0, 1, 2, 3}, {kQuiet, kNear, kAtIt, kPast});
    s.raise();
    const std::array modes{PointMode::surrogate, PointMode::replay, PointMode::replay, PointMode::replay};
    const std::array reasons{Reason::none, Reason::none, Reason::spread, Reason::strain};
    for (std::size_t p = 0; p < 4; ++p) {
        EXPECT_EQ(s.modes[p], modes[p]) << p;
        EXPECT_EQ(s.modes.reason(p), reasons[p]) << p;
    }
}

TEST(Raise, VerdictsBelongToThePointsThatWereAskedNotToTheirPlaces) {
    ScreeningStages s(3);
    for (std::size_t p = 0; p < 3; ++p) s.place(p, 10.0 * static_cast<double>(p), 0);
    s.judged({2, 0}, {kPast, kQuiet});
    s.raise();
    EXPECT_EQ(s.modes[2], PointMode::replay);
    EXPECT_EQ(s.modes[0], PointMode::surrogate);
    EXPECT_EQ(s.modes[1], PointMode::surrogate);
}

// Two columns and two rows of cells about the centre; half a cell more, the edge included.
TEST(Raise, NeighboursLieInASquareOfCellsInXAndInY) {
    ScreeningSetup setup = setup_of(1, 1);
    setup.hand_over.dilate = 1;
    ScreeningStages s(9, setup);
    const std::vector<std::pair<double, double>> places{
        {0, 0}, {1.5, 1.5}, {-1.5, 0.4}, {0.3, -1.5}, {1.6, 0}, {0, 1.6}, {-1.6, -0.2}, {0.2, -1.6}, {0, 40}};
    for (std::size_t p = 0; p < places.size(); ++p) s.place(p, 7 + places[p].first, 3 + places[p].second);
    s.judged({0}, {kPast});
    s.raise();
    EXPECT_EQ(neighbours(s), (std::vector<std::size_t>{1, 2, 3}));
    for (const std::size_t p : neighbours(s)) EXPECT_EQ(s.modes[p], PointMode::replay) << p;
    EXPECT_EQ(s.modes[4], PointMode::surrogate);
    EXPECT_EQ(s.modes[5], PointMode::surrogate);
}

TEST(Raise, TheSquareGrowsWithTheCellAndWithDilate) {
    for (const int dilate : {0, 1, 2, 3}) {
        ScreeningSetup setup = setup_of(1, 1);
        setup.hand_over.dilate = dilate;
        ScreeningStages s(6, setup);
        for (std::size_t p = 0; p < 6; ++p) s.place(p, 0, static_cast<double>(p));
        s.judged({0}, {kPast});
        s.raise();
        EXPECT_EQ(neighbours(s).size(), static_cast<std::size_t>(dilate)) << "upwards by whole cells";
    }
}

TEST(Raise, ANeighbourThatPassesTheGateItselfRaisesItsOwnAndNobodyDoesTwice) {
    ScreeningStages s(5);
    for (std::size_t p = 0; p < 5; ++p) s.place(p, 0, static_cast<double>(p));
    s.judged({0}, {kPast});
    s.raise();
    EXPECT_EQ(neighbours(s), std::vector<std::size_t>{1});
    s.judged({0, 1}, {{3, Reason::spread}, kPast});
    s.raise();
    EXPECT_EQ(s.modes.reason(0), Reason::strain) << "the first reason is kept";
    EXPECT_EQ(s.modes.reason(1), Reason::strain) << "a reason of its own";
    EXPECT_EQ(neighbours(s), std::vector<std::size_t>{2});
    s.modes.set_reason(2, Reason::none);
    s.judged({0, 1}, {kPast, kPast});
    s.raise();
    EXPECT_TRUE(neighbours(s).empty()) << "only the first time";
}

TEST(Raise, PointsByGrainsAreNoNeighbours) {
    ScreeningStages s(3);
    for (std::size_t p = 0; p < 3; ++p) s.place(p, 0.1 * static_cast<double>(p), 0);
    s.lead_to(PointMode::grains, 1), s.lead_to(PointMode::critical_state, 2);
    s.judged({0}, {kPast});
    s.raise();
    EXPECT_EQ(neighbours(s), std::vector<std::size_t>{2});
    EXPECT_EQ(s.modes[2], PointMode::critical_state) << "has no way to its grains but a failed answer";
}

TEST(Raise, AFailedAnswerReplacesAnyOtherReasonAndIsReplacedByNone) {
    ScreeningStages s(2);
    s.place(1, 50, 0);
    s.modes.set_reason(0, Reason::strain);
    s.judged({0}, {{1, Reason::failed_answer}});
    s.raise();
    EXPECT_EQ(s.modes.reason(0), Reason::failed_answer);
    s.judged({0}, {kPast});
    s.raise();
    EXPECT_EQ(s.modes.reason(0), Reason::failed_answer);
}

}  // namespace
}  // namespace sandgraph::graph

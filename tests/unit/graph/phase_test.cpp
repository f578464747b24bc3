#include "graph/phase.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <mutex>
#include <thread>

#include "base/random.hpp"
#include "graph/step_graph.hpp"

namespace sandgraph::graph {
namespace {

class Log {
  public:
    std::function<void()> noting(const char* name) {
        return [this, name] {
            const std::lock_guard guard(lock_);
            names_.emplace_back(name);
        };
    }
    std::vector<std::string> take() { return std::exchange(names_, {}); }

  private:
    std::mutex lock_;
    std::vector<std::string> names_;
};

std::vector<Phase> chain(Log& log) {
    return {{"scatter", {{Data::points, 0}, {Data::stress, 0}}, {{Data::grid, 1}}, log.noting("scatter")},
            {"update", {{Data::grid, 1}}, {{Data::grid, 2}}, log.noting("update")},
            {"gather",
             {{Data::grid, 2}, {Data::points, 0}},
             {{Data::points, 1}, {Data::increments, 1}},
             log.noting("gather")},
            {"law", {{Data::increments, 1}, {Data::stress, 0}}, {{Data::stress, 1}}, log.noting("law")},
            {"work", {{Data::stress, settled}, {Data::points, 1}}, {{Data::energy, 1}}, log.noting("work")}};
}

void shuffle(std::vector<Phase>& phases, Random& random) {
    for (std::size_t k = phases.size(); k > 1; --k) std::swap(phases[k - 1], phases[random.bits() % k]);
}

TEST(Phases, RunInTheOrderOfTheirDataHoweverTheyAreListed) {
    Random random(5);
    Log log;
    for (int trial = 0; trial < 24; ++trial) {
        std::vector<Phase> phases = chain(log);
        shuffle(phases, random);
        StepGraph graph(std::move(phases));
        graph.run();
        const std::vector<std::string> step = {"scatter", "update", "gather", "law", "work"};
        EXPECT_EQ(log.take(), step);
        graph.run();
        EXPECT_EQ(log.take(), step);
    }
}

// The edge that readers of an old version need: nobody overwrites what they still read.
TEST(Phases, AWriterWaitsForTheReadersOfTheVersionBefore) {
    const std::vector<Phase> phases = {
        {"write again", {}, {{Data::points, 1}}, [] {}},
        {"read old", {{Data::points, 0}}, {{Data::grid, 1}}, [] {}},
        {"read new", {{Data::points, 1}}, {{Data::energy, 1}}, [] {}},
    };
    const auto before = predecessors(phases);
    EXPECT_EQ(before[0], std::vector<std::size_t>{1});
    EXPECT_TRUE(before[1].empty());
    EXPECT_EQ(before[2], std::vector<std::size_t>{0});
}

TEST(Phases, AReaderOfWhatHasSettledWaitsForTheLastWriter) {
    const std::vector<Phase> phases = {{"last", {{Data::stress, 1}}, {{Data::stress, 2}}, [] {}},
                                       {"sum", {{Data::stress, settled}}, {}, [] {}},
                                       {"first", {}, {{Data::stress, 1}}, [] {}}};
    const auto before = predecessors(phases);
    EXPECT_EQ(before[1], std::vector<std::size_t>{0});
    EXPECT_EQ(before[0], std::vector<std::size_t>{2});
}

TEST(Phases, RefuseTwoWritersOfAVersion) {
    const std::vector<Phase> phases = {{"a", {}, {{Data::grid, 1}}, [] {}},
                                       {"b", {}, {{Data::grid, 1}}, [] {}}};
    EXPECT_THROW(predecessors(phases), std::logic_error);
}

TEST(Phases, RefuseToReadWhatNobodyWrites) {
    EXPECT_THROW(predecessors({{"a", {{Data::grid, 1}}, {}, [] {}}}), std::logic_error);
    EXPECT_THROW(predecessors({{"a", {}, {{Data::grid, 2}}, [] {}}}), std::logic_error);
}

TEST(Phases, RefuseACircle) {
    const std::vector<Phase> phases = {{"a", {{Data::stress, 1}}, {{Data::grid, 1}}, [] {}},
                                       {"b", {{Data::grid, 1}}, {{Data::stress, 1}}, [] {}}};
    EXPECT_THROW(predecessors(phases), std::logic_error);
}

TEST(StepGraph, HandsOnWhatAPhaseThrows) {
    StepGraph graph({{"a", {}, {{Data::grid, 1}}, [] { throw std::runtime_error("broken"); }},
                     {"b", {{Data::grid, 1}}, {}, [] { FAIL(); }}});
    EXPECT_THROW(graph.run(), std::runtime_error);
}

TEST(StepGraph, TellsTheTimeOfEachPhase) {
    using namespace std::chrono_literals;
    StepGraph graph({{"slow", {}, {{Data::grid, 1}}, [] { std::this_thread::sleep_for(20ms); }},
                     {"quick", {{Data::grid, 1}}, {}, [] {}}});
    graph.run(), graph.run();
    ASSERT_EQ(graph.times().size(), 2u);
    EXPECT_EQ(graph.times()[0].name, "slow");
    EXPECT_GE(graph.times()[0].seconds, 0.04);
    EXPECT_GT(graph.times()[1].seconds, 0);
    EXPECT_LT(graph.times()[1].seconds, graph.times()[0].seconds);
}

}  // namespace
}  // namespace sandgraph::graph

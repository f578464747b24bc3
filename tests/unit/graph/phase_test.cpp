#include "graph/phase.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <mutex>
#include <thread>

#include "base/random.hpp"
#include "graph/step_graph.hpp"

namespace sandgraph::graph {
namespace {

std::vector<Phase> chain(std::vector<std::string>& log, std::mutex& lock) {
    const auto note = [&](const char* name) {
        return [&log, &lock, name] {
            const std::lock_guard guard(lock);
            log.emplace_back(name);
        };
    };
    return {{"scatter", {"points"}, {"sums"}, note("scatter")},
            {"update", {"sums"}, {"motion"}, note("update")},
            {"gather", {"motion"}, {"increments"}, note("gather")},
            {"law", {"increments"}, {"stress"}, note("law")}};
}

TEST(Phases, RunInTheOrderOfTheirDataHoweverTheyAreListed) {
    Random random(5);
    std::mutex lock;
    std::vector<std::string> log;
    for (int trial = 0; trial < 24; ++trial) {
        std::vector<Phase> phases = chain(log, lock);
        for (std::size_t k = phases.size(); k > 1; --k) std::swap(phases[k - 1], phases[random.bits() % k]);
        StepGraph graph(std::move(phases));
        log.clear();
        graph.run();
        graph.run();
        const std::vector<std::string> step = {"scatter", "update", "gather", "law"};
        std::vector<std::string> twice = step;
        twice.insert(twice.end(), step.begin(), step.end());
        EXPECT_EQ(log, twice);
    }
}

TEST(Phases, RefuseTwoWritersOfAResource) {
    const std::vector<Phase> phases = {{"a", {}, {"x"}, [] {}}, {"b", {}, {"x"}, [] {}}};
    EXPECT_THROW(predecessors(phases), std::logic_error);
}

TEST(Phases, RefuseACircle) {
    const std::vector<Phase> phases = {{"a", {"y"}, {"x"}, [] {}}, {"b", {"x"}, {"y"}, [] {}}};
    EXPECT_THROW(predecessors(phases), std::logic_error);
}

TEST(StepGraph, HandsOnWhatAPhaseThrows) {
    StepGraph graph(
        {{"a", {}, {"x"}, [] { throw std::runtime_error("broken"); }}, {"b", {"x"}, {}, [] { FAIL(); }}});
    EXPECT_THROW(graph.run(), std::runtime_error);
}

TEST(StepGraph, TellsTheTimeOfEachPhase) {
    using std::chrono::steady_clock, std::chrono::duration, std::this_thread::sleep_for;
    constexpr std::chrono::milliseconds a_takes(20), b_takes(5);
    StepGraph graph(
        {{"a", {}, {"x"}, [&] { sleep_for(a_takes); }}, {"b", {"x"}, {}, [&] { sleep_for(b_takes); }}});
    const auto begin = steady_clock::now();
    graph.run();
    graph.run();
    const double wall = duration<double>(steady_clock::now() - begin).count();
    ASSERT_EQ(graph.times().size(), 2u);
    const PhaseTime &a = graph.times()[0], &b = graph.times()[1];
    EXPECT_EQ(a.name, "a");
    EXPECT_EQ(b.name, "b");
    EXPECT_GE(a.seconds, 2 * 0.02);  // of both steps; sleeps are never shorter
    EXPECT_GE(b.seconds, 2 * 0.005);
    EXPECT_LE(a.seconds + b.seconds, wall);  // one after the other
}

}  // namespace
}  // namespace sandgraph::graph

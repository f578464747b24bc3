// 8,000 RVEs with the spread of DEM steps of a real pull-out, updated by one thread and by two in turn,
// longest first. The spread is that of the dense anchor at H/B = 3 pulled to 0.4 B: points by their final
// shear strain. Besides wall time: processor time of the busier of two threads against that of one, which
// holds on a loaded machine too (it shows balance and shared caches, not other programs). Usage:
// bench_rve_threads [rounds]
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <thread>

#include "dem/packing/csv.hpp"
#include "dem/packing/observables.hpp"
#include "dem/rve.hpp"
#include "support/paths.hpp"
#include "tests/support/table1_options.hpp"

namespace {

using namespace sandgraph;
using namespace sandgraph::dem;

constexpr int kRves = 8000;
const Material kMaterial;

// DEM steps of each RVE in one round, longest first: strained above 30 %, 10 to 30 %, 1 to 10 %, less.
std::vector<int> spread() {
    std::vector<int> steps;
    const auto add = [&](int points, int count) { steps.insert(steps.end(), points, count); };
    add(139, 793), add(61, 212), add(297, 71), add(kRves - 497, 2);
    return steps;
}

double seconds(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Times {
    double wall, busiest;
};

Times round_of(std::vector<Rve>& rves, const std::vector<int>& steps, int threads, double shear) {
    std::atomic<int> next{0};
    std::vector<double> busy(threads);
    const auto work = [&](int thread) {
        const double start = seconds(CLOCK_THREAD_CPUTIME_ID);
        static thread_local Workspace workspace;
        RveOptions options = support::table1_options();
        for (int k = next++; k < kRves; k = next++) {
            options.steps_min = steps[k];
            const Mat2 F = (Mat2() << 1, shear * steps[k], 0, 1).finished();
            rves[k].update(F, kMaterial, options, workspace);
        }
        busy[thread] = seconds(CLOCK_THREAD_CPUTIME_ID) - start;
    };
    const double start = seconds(CLOCK_MONOTONIC);
    std::vector<std::thread> pool;
    for (int t = 0; t < threads; ++t) pool.emplace_back(work, t);
    for (std::thread& t : pool) t.join();
    return {seconds(CLOCK_MONOTONIC) - start, *std::max_element(busy.begin(), busy.end())};
}

double median(std::vector<double> v) {
    std::sort(v.begin(), v.end());
    return v[v.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
    const int rounds = argc > 1 ? std::atoi(argv[1]) : 7;
    const Packing packing = read_packing_csv(sandgraph::test::test_data("/yade/packing_dense_p32.csv"));
    const auto initial = compact(packing, kMaterial, 32e3 * Mat2::Identity());
    std::vector<Rve> rves;
    for (int k = 0; k < kRves; ++k) rves.emplace_back(initial);
    const std::vector<int> steps = spread();
    double total = 0;
    for (const int s : steps) total += s;
    round_of(rves, steps, 2, 1e-8);  // every RVE gets its own packing
    std::vector<double> wall, busy;
    for (int round = 0; round < rounds; ++round) {
        const double shear = round % 2 ? 1e-8 : -1e-8;
        const Times one = round_of(rves, steps, 1, shear), two = round_of(rves, steps, 2, shear);
        wall.push_back(one.wall / two.wall), busy.push_back(one.busiest / two.busiest);
        std::printf(
            "round %d: 1 thread %.3f s (busy %.3f s, %.2f us a DEM step), 2 threads %.3f s (busier %.3f s)\n",
            round, one.wall, one.busiest, 1e6 * one.busiest / total, two.wall, two.busiest);
    }
    std::printf(
        "%d RVEs, %.0f DEM steps a round; 2 threads against 1, medians: wall %.2f, processor time %.2f\n",
        kRves, total, median(wall), median(busy));
}

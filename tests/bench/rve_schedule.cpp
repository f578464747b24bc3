// How the DEM updates of real MPM steps spread over workers: a scene is pulled to d/B, the updates of the
// next steps are recorded, and list scheduling is simulated on 1 to 512 workers, longest expected first (as
// the program does) against the order of the points. Usage: bench_rve_schedule SCENE.toml [d/B] [steps]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <queue>

#include "graph/rve_law.hpp"
#include "scene/read_scene.hpp"
#include "simulation/scene_spec.hpp"

namespace {

using namespace sandgraph;

// Cost of an update in DEM steps: what it takes to fetch and store a packing is worth about three.
constexpr double kVisit = 3;

using Costs = std::vector<double>;

double makespan(const Costs& costs, int workers) {
    std::priority_queue<double, std::vector<double>, std::greater<>> free_at;
    for (int w = 0; w < workers; ++w) free_at.push(0);
    double end = 0;
    for (const double cost : costs) {
        const double done = free_at.top() + cost;
        free_at.pop();
        free_at.push(done);
        end = std::max(end, done);
    }
    return end;
}

// A fixed shuffle: the points' own order says nothing of their cost.
Costs shuffled(Costs costs) {
    std::uint64_t state = 1;
    for (std::size_t k = costs.size(); k > 1; --k) {
        state = state * 6364136223846793005ull + 1442695040888963407ull;
        std::swap(costs[k - 1], costs[(state >> 33) % k]);
    }
    return costs;
}

}  // namespace

int main(int argc, char** argv) {
    const scene::Scene scene = scene::read_scene(argc > 1 ? argv[1] : "configs/anchor_horizontal.toml");
    const double until = argc > 2 ? std::atof(argv[2]) : 0.02;
    const int steps = argc > 3 ? std::atoi(argv[3]) : 50;
    const auto pull = simulation::simulation_of(scene, packings::prepare_ground(scene));
    const auto& law = dynamic_cast<const graph::RveLaw&>(*pull->state().law);
    while (pull->d_over_B() < until) pull->step();
    std::vector<Costs> recorded;
    double total = 0, updates = 0, longest = 0;
    for (int step = 0; step < steps; ++step) {
        pull->step();
        Costs costs;
        for (const graph::RveAnswer& a : law.last_answers()) costs.push_back(kVisit + a.report.dem_steps);
        for (const double c : costs) total += c, longest = std::max(longest, c);
        updates += static_cast<double>(costs.size());
        recorded.push_back(std::move(costs));
    }
    std::printf("d/B %.3f: %.0f updates a step, %.1f DEM steps each, longest %.0f\n", until, updates / steps,
                total / updates - kVisit, longest - kVisit);
    std::printf("workers  speed-up longest first  in arbitrary order\n");
    for (const int workers : {1, 2, 8, 64, 512}) {
        double sorted = 0, arbitrary = 0;
        for (const Costs& costs : recorded)
            sorted += makespan(costs, workers), arbitrary += makespan(shuffled(costs), workers);
        std::printf("%7d  %22.2f  %18.2f\n", workers, total / sorted, total / arbitrary);
    }
}

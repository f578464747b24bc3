// How the DEM updates of real MPM steps spread over workers: a scene is pulled to d/B, the updates of the
// next steps are recorded, and list scheduling is simulated on 1 to 512 workers, longest expected first (as
// the program does) against the order of the points. Beside it the whole step, with the other phases as they
// were measured on one thread, each over as many workers as it has tasks; and what the step graph itself
// costs. Usage: bench_rve_schedule SCENE.toml [d/B] [steps] [section.key=value ...]
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <queue>
#include <string>

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

// Tasks of a phase, one if it is serial: bands of the grid by two for the transfers, rows of nodes, blocks of
// points (engine/graph/rve_law.cpp).
double tasks_of(const std::string& phase, const graph::GroundState& s) {
    if (phase == "points to grid" || phase == "grid to points") return double(s.order.bands()) / 2;
    if (phase == "grid update") return double(s.order.bands());
    if (phase == "predict") return std::ceil(double(s.all_points.size()) / 1024);
    return 1;
}

using Times = std::map<std::string, double>;

Times times_of(const graph::StepGraph& graph) {
    Times out;
    for (const graph::PhaseTime& t : graph.times()) out[t.name] += t.seconds;
    return out;
}

struct Recorded {
    std::vector<Costs> steps;
    Times before, after;
    double total = 0, updates = 0, longest = 0;

    double seconds(const std::string& phase) const {
        return after.at(phase) - (before.contains(phase) ? before.at(phase) : 0);
    }
    double grains(int workers) const {
        double sum = 0;
        for (const Costs& costs : steps) sum += makespan(costs, workers);
        return sum;
    }
    double whole_step(int workers, const graph::GroundState& s) const {
        double sum = seconds("grains") * grains(workers) / total;
        for (const auto& [phase, unused] : after)
            if (phase != "grains") sum += seconds(phase) / std::min<double>(workers, tasks_of(phase, s));
        return sum;
    }
};

Recorded record(simulation::Simulation& pull, int steps) {
    const auto& law = dynamic_cast<const graph::RveLaw&>(*pull.state().law);
    Recorded out;
    out.before = times_of(pull.graph());
    for (int step = 0; step < steps; ++step) {
        pull.step();
        Costs costs;
        for (const graph::RveAnswer& a : law.last_answers()) costs.push_back(kVisit + a.report.dem_steps);
        for (const double c : costs) out.total += c, out.longest = std::max(out.longest, c);
        out.updates += static_cast<double>(costs.size());
        out.steps.push_back(std::move(costs));
    }
    out.after = times_of(pull.graph());
    return out;
}

// Of a step whose phases do nothing [us].
double graph_overhead(const graph::StepGraph& real) {
    std::vector<graph::Phase> phases = real.phases();
    for (graph::Phase& phase : phases) phase.run = [] {};
    graph::StepGraph idle(std::move(phases));
    constexpr int runs = 20000;
    const auto begin = std::chrono::steady_clock::now();
    for (int k = 0; k < runs; ++k) idle.run();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() / runs * 1e6;
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> overrides(argv + std::min(argc, 4), argv + argc);
    const scene::Scene scene =
        scene::read_scene(argc > 1 ? argv[1] : "configs/anchor_horizontal.toml", overrides);
    const double until = argc > 2 ? std::atof(argv[2]) : 0.02;
    const int steps = argc > 3 ? std::atoi(argv[3]) : 50;
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const auto pull = simulation::simulation_of(scene, packings::prepare_ground(scene));
    while (pull->d_over_B() < until) pull->step();
    const Recorded r = record(*pull, steps);
    std::printf("d/B %.3f: %.0f updates a step, %.1f DEM steps each, longest %.0f\n", until,
                r.updates / steps, r.total / r.updates - kVisit, r.longest - kVisit);
    std::printf("workers  speed-up longest first  in arbitrary order  whole step\n");
    for (const int workers : {1, 2, 8, 64, 512}) {
        double arbitrary = 0;
        for (const Costs& costs : r.steps) arbitrary += makespan(shuffled(costs), workers);
        std::printf("%7d  %22.2f  %18.2f  %10.2f\n", workers, r.total / r.grains(workers),
                    r.total / arbitrary,
                    r.whole_step(1, pull->state()) / r.whole_step(workers, pull->state()));
    }
    std::printf("step graph, phases that do nothing: %.2f us a step\n", graph_overhead(pull->graph()));
}

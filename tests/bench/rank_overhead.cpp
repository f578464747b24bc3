// What the exchange costs where there is nothing to exchange with: one ground twice in one process, its
// packings in a pool of this process and in one shared out by MPI to one rank, driven in turn on one thread.
// Both do the same work to the bit; processor time of 40 rounds, and of each the ratio. Usage:
//   bench_rank_overhead SCENE.toml [d/B] [steps a round] [section.key=value ...]
#include <tbb/global_control.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

#include "mpi/mpi_team.hpp"
#include "ranks/rank_pool.hpp"
#include "scene/read_scene.hpp"
#include "simulation/prepare_run.hpp"
#include "simulation/scene_spec.hpp"

namespace {

using namespace sandgraph;

constexpr int kRounds = 40;

double seconds_of(simulation::Simulation& pull, int steps) {
    const std::clock_t begin = std::clock();
    for (int k = 0; k < steps; ++k) pull.step();
    return double(std::clock() - begin) / CLOCKS_PER_SEC;
}

}  // namespace

int main(int argc, char** argv) {
    mpi::MpiTeam team(argc, argv);
    const std::vector<std::string> overrides(argv + std::min(argc, 4), argv + argc);
    const scene::Scene scene = scene::read_scene(argc > 1 ? argv[1] : "configs/quick.toml", overrides);
    const double until = argc > 2 ? std::atof(argv[2]) : 0.005;
    const int steps = argc > 3 ? std::atoi(argv[3]) : 20;
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const packings::PreparedGround ground = simulation::prepare_quietly(scene);
    const auto alone = simulation::simulation_of(scene, ground);
    const auto shared =
        simulation::simulation_of(scene, ground, [&](const auto& i, const auto& m, const auto& o) {
            auto pool = std::make_unique<ranks::RankPool>(team, i, m, o);
            pool->announce(false);
            return pool;
        });
    while (alone->d_over_B() < until) alone->step(), shared->step();
    double sum[2] = {};
    std::vector<double> ratios;
    for (int round = 0; round < kRounds; ++round) {
        double a = 0, b = 0;  // whoever comes second finds the caches another's: in turn
        if (round % 2 == 0) a = seconds_of(*alone, steps), b = seconds_of(*shared, steps);
        if (round % 2 == 1) b = seconds_of(*shared, steps), a = seconds_of(*alone, steps);
        sum[0] += a, sum[1] += b;
        ratios.push_back(b / a);
    }
    std::ranges::sort(ratios);
    std::printf(
        "%d rounds of %d steps: %.2f s alone, %.2f s as one rank (%+.2f %%); median of the ratios %+.2f %%, "
        "quartiles %+.2f and %+.2f %%; loads %s\n",
        kRounds, steps, sum[0], sum[1], 100 * (sum[1] / sum[0] - 1), 100 * (ratios[kRounds / 2] - 1),
        100 * (ratios[kRounds / 4] - 1), 100 * (ratios[3 * kRounds / 4] - 1),
        alone->load() == shared->load() ? "equal" : "DIFFERENT");
}

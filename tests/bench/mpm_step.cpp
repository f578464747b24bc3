// Point updates a second of the macro scale with an elastic law, phase by phase, by wall clock. CPU/wall
// below the thread count: the machine is shared, or the threads wait. Usage: bench_mpm_step [seconds per
// case]
#include <fmt/format.h>
#include <oneapi/tbb/task_arena.h>

#include <chrono>
#include <cstdlib>
#include <ctime>

#include "tests/support/bare_spec.hpp"

namespace {

using namespace sandgraph;
using Clock = std::chrono::steady_clock;

struct Case {
    int columns, rows, per_cell;  // cells
};

simulation::Spec make(const Case& c) {
    const double cell = 0.1;
    simulation::Spec spec;
    spec.grid = {0, 0, cell, c.columns, c.rows + 10};
    spec.ground.extent = {0, 0, c.columns * cell, c.rows * cell};
    spec.ground.points_per_cell = c.per_cell;
    spec.ground.density = 2200;
    spec.law = support::elastic({20e6, 0.3});
    return spec;
}

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }
double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

void run(const Case& c, int threads, double budget) {
    simulation::Simulation model(make(c));
    support::steps(model, 20);
    const std::vector<graph::PhaseTime> before = model.graph().times();
    const double cpu = cpu_seconds();
    const auto start = Clock::now();
    int steps = 0;
    for (; seconds_since(start) < budget; ++steps) model.step();
    const double wall = seconds_since(start), n = static_cast<double>(model.state().points.size());
    fmt::print("{:7} points {} a cell {} threads: {:6.2f} M updates/s; ns a point:", n, c.per_cell, threads,
               1e-6 * n * steps / wall);
    for (std::size_t k = 0; k < before.size(); ++k)
        fmt::print(" {} {:.1f},", before[k].name,
                   1e9 * (model.graph().times()[k].seconds - before[k].seconds) / steps / n);
    fmt::print(" all {:.1f}; CPU/wall {:.2f}\n", 1e9 * wall / steps / n, (cpu_seconds() - cpu) / wall);
}

}  // namespace

int main(int argc, char** argv) {
    const double budget = argc > 1 ? std::atof(argv[1]) : 1;
    const Case cases[] = {{128, 128, 1}, {100, 80, 1}, {256, 256, 1},
                          {64, 64, 4},   {50, 40, 4},  {128, 128, 4}};
    for (const Case& c : cases)
        for (const int threads : {1, 2}) {
            oneapi::tbb::task_arena arena(threads);
            arena.execute([&] { run(c, threads, budget); });
        }
}

// Point updates a second of the macro scale, stage by stage, by wall clock. CPU/wall below the thread count:
// the machine is shared, or the threads wait. Usage: bench_mpm_step [seconds per case]
#include <fmt/format.h>
#include <oneapi/tbb/task_arena.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <ctime>

#include "mpm/layout.hpp"
#include "stress/elastic.hpp"
#include "tests/support/macro_model.hpp"

namespace {

using namespace sandgraph;
using Clock = std::chrono::steady_clock;

struct Case {
    int columns, rows, per_cell;  // cells
};

support::MacroModel make(const Case& c) {
    const double cell = 0.1;
    support::MacroModel model({0, 0, cell, c.columns, c.rows + 10});
    model.points = mpm::lay_out({{0, 0, c.columns * cell, c.rows * cell}, cell, c.per_cell, 2200, {}});
    model.update.gravity = {0, -9.81};
    model.update.damping = 0.05;
    model.update.boundaries = {mpm::Side::mirror, mpm::Side::mirror, mpm::Side::fixed, mpm::Side::free};
    model.advance.pic = 0.01;
    model.law = std::make_unique<stress::Elastic>(stress::ElasticConstants{20e6, 0.3},
                                                  std::vector<Stress>(model.points.size()));
    model.set_time_step(0.3 * cell / std::sqrt(model.law->p_wave_modulus() / 2200));
    model.start();
    return model;
}

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }
double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

// Seconds per step: order + points to grid, grid update, grid to points, law.
std::array<double, 4> time_stages(support::MacroModel& m, double budget, int& steps) {
    std::array<double, 4> total{};
    const auto lap = [&](int stage, auto&& work) {
        const auto start = Clock::now();
        work();
        total[static_cast<std::size_t>(stage)] += seconds_since(start);
    };
    const auto start = Clock::now();
    for (steps = 0; seconds_since(start) < budget; ++steps) {
        lap(0, [&] { m.load_grid(); });
        lap(1, [&] { mpm::update_grid(m.update, m.grid); });
        lap(2, [&] { mpm::grid_to_points(m.grid, m.advance, m.order, m.points); });
        lap(3, [&] { m.law->update({m.all, m.points.F_inc, m.points.stress, m.advance.dt}); });
    }
    for (double& t : total) t /= steps;
    return total;
}

void run(const Case& c, int threads, double budget) {
    support::MacroModel model = make(c);
    model.steps(20);
    int steps = 0;
    const double cpu = cpu_seconds();
    const auto t = time_stages(model, budget, steps);
    const double cpu_share = (cpu_seconds() - cpu) / ((t[0] + t[1] + t[2] + t[3]) * steps);
    const double n = static_cast<double>(model.points.size()), step = t[0] + t[1] + t[2];
    fmt::print(
        "{:7} points {} a cell {} threads: {:6.2f} M updates/s, {:6.2f} with the elastic law; "
        "ns a point: to grid {:.1f}, grid {:.1f}, to points {:.1f}, law {:.1f}; CPU/wall {:.2f}\n",
        model.points.size(), c.per_cell, threads, 1e-6 * n / step, 1e-6 * n / (step + t[3]), 1e9 * t[0] / n,
        1e9 * t[1] / n, 1e9 * t[2] / n, 1e9 * t[3] / n, cpu_share);
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

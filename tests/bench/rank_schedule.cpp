// What many ranks would make of a run: a scene is pulled to d/B on one thread, the DEM updates of the next
// steps are recorded, and the same steps are played by 1 to 4,096 cores, as ranks of 8 or 64 threads each.
// Owners are those of the program (engine/ranks/owners.hpp); a network is a latency and a bandwidth. What is
// simulated: each rank drives its packings, longest first, over its threads; all wait for the slowest; one
// collective carries the answers to all; every rank takes them in and computes the whole macro step, its
// phases over as many threads as they have tasks. Usage:
//   bench_rank_schedule SCENE.toml [d/B] [steps] [times] [latency us] [GB/s]
//   [section.key=value ...]
// `times`: beside this ground one so many times as large, of copies of it that are at different steps.
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <queue>
#include <string>

#include "ranks/answer_record.hpp"
#include "ranks/owners.hpp"
#include "scene/read_scene.hpp"
#include "simulation/prepare_run.hpp"
#include "simulation/scene_spec.hpp"

namespace {

using namespace sandgraph;

constexpr double kVisit = 3;            // what it takes to fetch and store a packing, in DEM steps
constexpr double kPackingBytes = 30e3;  // that moves to another rank
constexpr int kBalanceEvery = 200;      // steps

double wall() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}
double processor() { return double(std::clock()) / CLOCKS_PER_SEC; }

struct Update {
    std::size_t packing;
    int dem_steps;
};
using Step = std::vector<Update>;  // longest expected first

struct Phase {
    std::string name;
    double seconds, tasks;  // a step on one thread; tasks that it splits into
};

struct Recorded {
    std::vector<Step> steps;
    std::size_t packings = 0;
    double dem_step = 0;        // [s]
    std::vector<Phase> phases;  // but for the grains
    double grains = 0;          // [s] a step
};

struct Network {
    double latency, bandwidth;  // [s], [B/s]
};

// As many as the phase has: bands of the grid, blocks of points; one where it is serial.
double tasks_of(const std::string& phase, const graph::GroundState& s) {
    if (phase == "points to grid" || phase == "grid to points") return double(s.order.bands()) / 2;
    if (phase == "grid update") return double(s.order.bands());
    if (phase == "predict") return std::ceil(double(s.all_points.size()) / 1024);
    return 1;
}

std::vector<double> times_of(const graph::StepGraph& graph) {
    std::vector<double> out;
    for (const graph::PhaseTime& t : graph.times()) out.push_back(t.seconds);
    return out;
}

// A pool in this process that notes what it is asked for.
class RecordingPool final : public graph::RvePool {
  public:
    RecordingPool(std::unique_ptr<graph::RvePool> pool, Step& step) : pool_(std::move(pool)), step_(step) {
        floating_.assign(pool_->size(), 0);
    }
    void drive(std::span<const graph::RveJob> jobs, std::span<graph::RveAnswer> answers) override {
        pool_->drive(jobs, answers);
        for (std::size_t k = 0; k < jobs.size(); ++k) {
            step_.push_back({jobs[k].rve, answers[k].report.dem_steps});
            floating_[jobs[k].rve] = pool_->floating(jobs[k].rve);
        }
    }
    Mat2 stress(std::size_t rve) const override { return pool_->stress(rve); }
    double strain_per_step(std::size_t rve) const override { return pool_->strain_per_step(rve); }
    double porosity(std::size_t rve) const override { return pool_->porosity(rve); }
    void copy(std::size_t from, std::size_t to) override {
        pool_->copy(from, to);
        floating_[to] = pool_->floating(to);
    }
    std::size_t owning() const override { return pool_->owning(); }
    const dem::Rve& rve(std::size_t rve) const override { return pool_->rve(rve); }
    void save(ByteWriter& out) const override { pool_->save(out); }
    void load(ByteReader& in) override { pool_->load(in); }
    void save_one(std::size_t rve, ByteWriter& out) const override { pool_->save_one(rve, out); }
    void load_one(std::size_t rve, ByteReader& in) override { pool_->load_one(rve, in); }

  private:
    std::unique_ptr<graph::RvePool> pool_;
    Step& step_;  // the updates of the step that is going on
};

// `step`: what the simulation's pool notes.
Recorded record(simulation::Simulation& pull, Step& step, int steps) {
    Recorded out;
    const std::vector<double> before = times_of(pull.graph());
    const double wall_before = wall(), processor_before = processor();
    double cost = 0;
    for (int k = 0; k < steps; ++k) {
        step.clear();
        pull.step();
        for (const Update& u : step) cost += kVisit + u.dem_steps;
        out.steps.push_back(step);
    }
    // Of a machine that others use, too: as much as it would have been alone.
    const double share = std::min(1.0, (processor() - processor_before) / (wall() - wall_before));
    const std::vector<double> after = times_of(pull.graph());
    for (std::size_t k = 0; k < after.size(); ++k) {
        const std::string& name = pull.graph().times()[k].name;
        const double seconds = share * (after[k] - before[k]) / steps;
        if (name == "grains")
            out.grains = seconds, out.dem_step = seconds * steps / cost;
        else
            out.phases.push_back({name, seconds, tasks_of(name, pull.state())});
    }
    return out;
}

// To take one answer in [s].
double taking_in() {
    constexpr int count = 200'000;
    graph::RveJob job;
    job.increment = Mat2::Identity();
    graph::RveAnswer answer;
    ranks::KnownPacking packing;
    std::vector<std::uint8_t> bytes;
    ByteWriter out(bytes);
    for (int k = 0; k < count; ++k) ranks::put_record(job, answer, packing, false, out);
    std::vector<graph::RveAnswer> answers(4096);
    std::vector<ranks::KnownPacking> known(4096);
    ByteReader in(bytes);
    const double begin = processor();
    for (std::size_t k = 0; k < count; ++k)
        ranks::take_record(job, false, in, answers[k % 4096], known[k % 4096]);
    return (processor() - begin) / count;
}

// Of updates that start in their order on the first thread that is free [DEM steps].
double makespan(const std::vector<double>& costs, int threads) {
    std::priority_queue<double, std::vector<double>, std::greater<>> free_at;
    for (int t = 0; t < threads; ++t) free_at.push(0);
    double end = 0;
    for (const double cost : costs) {
        const double done = free_at.top() + cost;
        free_at.pop(), free_at.push(done);
        end = std::max(end, done);
    }
    return end;
}

struct Played {
    double step = 0;                                                      // [s]
    double grains = 0, macro = 0, exchange = 0, take_in = 0, moving = 0;  // its parts [s]
    double bytes = 0;                                                     // of answers a step
    double imbalance = 0;  // slowest rank over the mean, of the grains
};

class Play {
  public:
    Play(const Recorded& run, int times, int ranks, int threads, const Network& network)
        : run_(run),
          times_(times),
          ranks_(ranks),
          threads_(threads),
          network_(network),
          owners_(run.packings * std::size_t(times), ranks) {}

    // Twice through the record: the owners settle in the first.
    Played run(double take_in) {
        for (std::size_t s = 0; s < run_.steps.size(); ++s) play(s);
        sum_ = {}, mean_ = answers_ = 0;
        for (std::size_t s = 0; s < run_.steps.size(); ++s) play(s);
        const double n = double(run_.steps.size());
        sum_.imbalance = sum_.grains * ranks_ / mean_;
        sum_.grains /= n, sum_.exchange /= n, sum_.moving /= n, sum_.bytes /= n;
        sum_.take_in = ranks_ > 1 ? answers_ / n * take_in : 0;
        for (const Phase& p : run_.phases)
            sum_.macro += p.seconds * times_ / std::min<double>(threads_, p.tasks > 1 ? p.tasks * times_ : 1);
        sum_.step = sum_.grains + sum_.macro + sum_.exchange + sum_.take_in + sum_.moving;
        return sum_;
    }

  private:
    void play(std::size_t s) {
        std::vector<std::vector<double>> of_rank(static_cast<std::size_t>(ranks_));
        std::size_t answers = 0;
        for (int copy = 0; copy < times_; ++copy)
            for (const Update& u :
                 run_.steps[(s + std::size_t(copy) * run_.steps.size() / std::size_t(times_)) %
                            run_.steps.size()]) {
                const std::size_t packing = u.packing + std::size_t(copy) * run_.packings;
                of_rank[static_cast<std::size_t>(owners_.of(packing))].push_back(kVisit + u.dem_steps);
                owners_.measure(packing, u.dem_steps);
                ++answers;
            }
        drive(of_rank);
        exchange(answers);
        if (++steps_ % kBalanceEvery == 0 && ranks_ > 1) move(owners_.balance());
    }
    void drive(std::vector<std::vector<double>>& of_rank) {
        double slowest = 0, mean = 0;
        for (std::vector<double>& costs : of_rank) {
            std::ranges::sort(costs, std::greater<>());
            const double time = makespan(costs, threads_) * run_.dem_step;
            slowest = std::max(slowest, time), mean += time;
        }
        sum_.grains += slowest, mean_ += mean;
    }
    // Recursive doubling.
    void exchange(std::size_t answers) {
        if (ranks_ == 1) return;
        graph::RveJob job;
        const double bytes = double(answers * ranks::record_bytes(job, false)) + 16.0 * ranks_;
        sum_.bytes += bytes, answers_ += double(answers);
        sum_.exchange += network_.latency * std::ceil(std::log2(ranks_)) + bytes / network_.bandwidth;
    }
    void move(const std::vector<ranks::Owners::Move>& moves) {
        std::vector<double> busy(static_cast<std::size_t>(ranks_), 0);
        for (const auto& m : moves)
            for (const int rank : {m.from, m.to})
                busy[static_cast<std::size_t>(rank)] += network_.latency + kPackingBytes / network_.bandwidth;
        sum_.moving += *std::ranges::max_element(busy);
    }

    const Recorded& run_;
    int times_, ranks_, threads_;
    Network network_;
    ranks::Owners owners_;
    Played sum_;
    double mean_ = 0, answers_ = 0;
    int steps_ = 0;
};

void print(const Recorded& run, int times, int threads_most, const Network& network, double take_in) {
    std::size_t updates = 0;
    for (const Step& step : run.steps) updates += step.size();
    std::printf("%.0f points, %.0f updates a step, %.2f us a DEM step, %.0f ns to take an answer in\n",
                double(run.packings) * times, double(updates) * times / double(run.steps.size()),
                run.dem_step * 1e6, take_in * 1e9);
    std::printf(
        "cores  ranks  ms a step  efficiency  grains  macro  exchange  take in  moving  kB a step  "
        "slowest/mean\n");
    double alone = 0;
    for (int cores = 1; cores <= 4096; cores *= 2) {
        const int threads = std::min(cores, threads_most), ranks = cores / threads;
        const Played p = Play(run, times, ranks, threads, network).run(take_in);
        if (cores == 1) alone = p.step;
        std::printf("%5d  %5d  %9.3f  %8.0f %%  %6.3f  %5.3f  %8.3f  %7.3f  %6.3f  %9.1f  %12.2f\n", cores,
                    ranks, 1e3 * p.step, 100 * alone / p.step / cores, 1e3 * p.grains, 1e3 * p.macro,
                    1e3 * p.exchange, 1e3 * p.take_in, 1e3 * p.moving, p.bytes / 1e3, p.imbalance);
    }
}

}  // namespace

int main(int argc, char** argv) {
    const auto number = [&](int place, double otherwise) {
        return argc > place ? std::atof(argv[place]) : otherwise;
    };
    const std::vector<std::string> overrides(argv + std::min(argc, 7), argv + argc);
    const scene::Scene scene =
        scene::read_scene(argc > 1 ? argv[1] : "configs/anchor_horizontal.toml", overrides);
    const int steps = int(number(3, 400)), times = int(number(4, 1));
    const Network network{number(5, 2) * 1e-6, number(6, 10) * 1e9};
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    Step step;
    std::size_t packings = 0;
    const auto pull = simulation::simulation_of(
        scene, simulation::prepare_quietly(scene),
        [&](const auto& initial, const auto& material, const auto& o) {
            packings = initial.size();
            return std::make_unique<RecordingPool>(graph::local_pool(initial, material, o), step);
        });
    while (pull->d_over_B() < number(2, 0.02)) pull->step();
    Recorded run = record(*pull, step, steps);
    run.packings = packings;
    const double take_in = taking_in();
    for (const Phase& p : run.phases)
        std::printf("%-16s %.4f ms on one thread, %.0f tasks\n", p.name.c_str(), 1e3 * p.seconds, p.tasks);
    for (const int threads : {8, 64}) {
        print(run, 1, threads, network, take_in);
        if (times > 1) print(run, times, threads, network, take_in);
    }
}

#include <sys/ptrace.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <ctime>

#include "dem/fast/neighbour_list.hpp"
#include "dem/fast/packing.hpp"
#include "dem/packing/compact_packing.hpp"
#include "dem/packing/csv.hpp"
#include "tests/bench/kernel_forms.hpp"

namespace sandgraph::dem::bench {
namespace {

constexpr double kStep = 1e-5;
const KernelConstants kLaw = kernel_constants(Material{});

// Steps of simple shear; the time spent in list rebuilds [s], and how many there were.
std::pair<double, int> shear(FastState& s, NeighbourList& neighbours, int steps) {
    const Mat2 L = (Mat2() << 0, 0.4, 0, 0).finished();
    double spent = 0;
    int rebuilds = 0;
    for (int k = 0; k < steps; ++k) {
        if (neighbours.stale(s)) {
            const double start = seconds();
            neighbours.rebuild(s);
            spent += seconds() - start, ++rebuilds;
        }
        contact_forces(s, kLaw, kStep, nullptr);
        s.approach += neighbours.approach(s, kick_drift(s, kLaw, L, kStep), kStep);
    }
    return {spent, rebuilds};
}

// By single-stepping a child through it: virtual machines seldom offer counters. 0 where that is forbidden.
long instructions(const std::function<void()>& run) {
    run();
    const pid_t child = fork();
    if (child == 0) {
        if (ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) != 0) _exit(1);
        raise(SIGSTOP);
        run();
        raise(SIGSTOP);
        _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    long count = 0;
    while (WIFSTOPPED(status) && (count == 0 || WSTOPSIG(status) == SIGTRAP)) {
        if (ptrace(PTRACE_SINGLESTEP, child, nullptr, nullptr) != 0) break;
        waitpid(child, &status, 0), ++count;
    }
    if (!WIFEXITED(status)) kill(child, SIGKILL), waitpid(child, &status, 0);
    return count > 1 ? count : 0;
}

std::size_t state_bytes(const FastState& s) {
    return 8 * (s.record.size() + s.force.size() + 2 * s.inverse_mass.size() + 2 * s.tangential.size()) +
           5 * s.i.size();
}

}  // namespace

double seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double clock_GHz() {
    constexpr long kAdditions = 100'000'000;
    const double start = seconds();
    long x = 0;
    for (long k = 0; k < kAdditions; ++k) {
        ++x;
        asm volatile("" : "+r"(x));
    }
    return 1e-9 * kAdditions / (seconds() - start);
}

std::vector<double> medians(const std::vector<std::function<void()>>& runs) {
    constexpr int kRounds = 31, kRuns = 300;
    std::vector<std::vector<double>> times(runs.size());
    for (int round = 0; round < kRounds; ++round)
        for (std::size_t f = 0; f < runs.size(); ++f) {
            const double start = seconds();
            for (int k = 0; k < kRuns; ++k) runs[f]();
            times[f].push_back((seconds() - start) / kRuns);
        }
    std::vector<double> out;
    for (std::vector<double>& t : times) {
        std::nth_element(t.begin(), t.begin() + kRounds / 2, t.end());
        out.push_back(t[kRounds / 2]);
    }
    return out;
}

Sheared::Sheared(const std::string& packing_csv) {
    const Packing packing = read_packing_csv(packing_csv);
    load(packing, Material{}, state);
    NeighbourList neighbours;
    neighbours.relist(state, packing.contacts);
    shear(state, neighbours, 3000);
    later = state;
    const double start = seconds();
    const auto [spent, rebuilds] = shear(later, neighbours, 30'000);
    rebuild_share = spent / (seconds() - start);
    steps_per_rebuild = 30'000.0 / std::max(1, rebuilds);
    neighbours.rebuild(state), neighbours.rebuild(later);
    for (FastState* s : {&state, &later}) contact_forces(*s, kLaw, kStep, nullptr);
}

int Sheared::contacts() const {
    int out = 0;
    for (int c = 0; c < state.slots; ++c) out += state.tangential[c] != 0;
    return out;
}

void print_machine(const Sheared& sheared, double clock, int contacts) {
    FastState s = sheared.state;
    const auto forces = [&] { contact_forces(s, kLaw, kStep, nullptr); };
    const auto motion = [&] { kick_drift(s, kLaw, s.L, 1e-15); };
    const std::vector<double> times = medians({forces, motion});
    const double pairs = s.pairs;
    const long in_forces = instructions(forces), in_motion = instructions(motion);
    const double cycles = 1e9 * clock * times[0], cycles_motion = 1e9 * clock * times[1];
    std::printf("\nforces %.3f us: %.1f cycles and %.0f instructions a contact (%.1f a cycle)\n",
                1e6 * times[0], cycles / contacts, double(in_forces) / contacts, double(in_forces) / cycles);
    std::printf("motion %.3f us: %.1f cycles and %.0f instructions a grain (%.1f a cycle)\n", 1e6 * times[1],
                cycles_motion / s.grains, double(in_motion) / s.grains, double(in_motion) / cycles_motion);
    // Two records, indices, history in and out, the pair's force out and in, two grain forces in and out.
    const double pair_bytes = 2 * 64 + 5 + 2 * 16 + 2 * 32 + 4 * 32;
    // Record in and out, force cleared and read, mass and inertia.
    const double step_bytes = pair_bytes * pairs + s.grains * (2 * 64 + 2 * 32 + 16);
    std::printf("bytes moved: %.0f a contact, %.0f kB a step, %.1f a cycle\n", pair_bytes * pairs / contacts,
                1e-3 * step_bytes, step_bytes / (cycles + cycles_motion));
    std::printf("list: %.2f pairs a contact, rebuilt every %.0f steps, %.1f %% of the time in shear\n",
                pairs / contacts, sheared.steps_per_rebuild, 100 * sheared.rebuild_share);
    CompactPacking rest;
    pack(s, rest);
    std::printf("memory: %.1f kB an RVE at rest, %.1f kB of working state a thread\n",
                1e-3 * double(rest.bytes()), 1e-3 * double(state_bytes(s)));
}

}  // namespace sandgraph::dem::bench

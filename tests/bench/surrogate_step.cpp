// Cost of a surrogate's point update in microseconds on one core, by instruction set and batch: one point,
// one vector, a cell row, a ground (states out of the cache). The increments are those of a screening step,
// one substep each. Usage: bench_surrogate_step [MODEL.h5] [seconds per case]
#include <fmt/format.h>
#include <hwy/targets.h>

#include <cstdlib>
#include <ctime>

#include "surrogate/kernel.hpp"
#include "surrogate/load_surrogate.hpp"
#include "surrogate/reference.hpp"
#include "tests/support/random_model.hpp"

namespace {

using namespace sandgraph;

struct Ground {
    explicit Ground(const stress::Surrogate& l, std::size_t count)
        : law(l), states(count * law.state_size()), answers(count) {
        Random random(7);
        for (std::size_t i = 0; i < count; ++i) {
            ids.push_back(static_cast<std::int32_t>(i));
            law.start(support::dense_traits(), support::rest_stress(),
                      std::span(states).subspan(i * law.state_size(), law.state_size()));
            const auto draw = [&] { return random.uniform(-2e-5, 2e-5); };
            const double e = draw(), xy = draw(), yx = draw();
            F.push_back((Mat2() << 1 + e, xy, yx, 1 - e).finished());
            back.push_back((Mat2() << 1 - e, -xy, -yx, 1 + e).finished());
        }
    }
    void step() { law.update(ids, (count_++ & 32) ? back : F, states, answers); }

    const stress::Surrogate& law;
    std::vector<double> states;
    std::vector<stress::SurrogateAnswer> answers;
    std::vector<std::int32_t> ids;
    std::vector<Mat2> F, back;
    int count_ = 0;
};

double cpu_seconds() {
    std::timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// CPU time of the best of twenty rounds, in microseconds a point: the machine may be shared.
double time_update(const stress::Surrogate& law, std::size_t points, double budget) {
    Ground ground(law, points);
    ground.step();
    double best = 1e300;
    for (int round = 0; round < 20; ++round) {
        const double start = cpu_seconds();
        double elapsed = 0, steps = 0;
        for (; elapsed < budget / 20; ++steps) {
            ground.step();
            elapsed = cpu_seconds() - start;
        }
        best = std::min(best, 1e6 * elapsed / (steps * static_cast<double>(points)));
    }
    return best;
}

void print_row(const std::string& name, const stress::Surrogate& law, double budget) {
    fmt::print("{:>8}", name);
    for (const std::size_t points : {1, 8, 300, 8000})
        fmt::print("  {:6} points {:7.3f} us", points, time_update(law, points, budget));
    fmt::print("\n");
}

}  // namespace

int main(int argc, char** argv) {
    const bool file = argc > 1 && std::string(argv[1]).ends_with(".h5");
    const double budget = argc > (file ? 2 : 1) ? std::atof(argv[file ? 2 : 1]) : 0.5;
    const surrogate::Model model = support::random_model(1);
    const auto law = file ? surrogate::load_surrogate(argv[1]) : surrogate::make_surrogate(model);
    fmt::print("{} doubles of state a point\n", law->state_size());
    for (const std::int64_t target : surrogate::kernel_targets()) {
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
        print_row(surrogate::kernel_target(), *law, budget);
    }
    if (!file) print_row("scalar", surrogate::Reference(model), budget);
}

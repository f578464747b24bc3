#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "base/contracts.hpp"
#include "dem/element_test/sample.hpp"
#include "dem/element_test/servo.hpp"

namespace sandgraph::dem {
namespace {

constexpr int servo_interval = 10;       // steps
constexpr double servo_response = 2e-3;  // of Table 1 grains [s]: slower than the packing's own vibrations

bool at_pressure(const Mat2& stress, const IsotropicTest& test) {
    return std::abs(stress(0, 0) - test.pressure) < test.tolerance * test.pressure &&
           std::abs(stress(1, 1) - test.pressure) < test.tolerance * test.pressure;
}

// One servo interval; returns the steps done.
int drive(SampleOnStand& sample, StressServo& x, StressServo& y, const IsotropicTest& test) {
    const Mat2 stress = sample.assembly().stress();
    const double interval = servo_interval * test.time_step;
    Mat2 L = Mat2::Zero();
    L(0, 0) = -x.rate(test.pressure - stress(0, 0), interval);
    L(1, 1) = -y.rate(test.pressure - stress(1, 1), interval);
    sample.step(L, servo_interval);
    return servo_interval;
}

}  // namespace

std::vector<ElementRow> run_isotropic(Assembly& assembly, IsotropicTest test, const GrainScale& grains) {
    by_grains(test.pressure, test.rate, test.time_step, grains);
    SG_EXPECT(test.sample_every > 0);
    assembly.step(Mat2::Zero(), test.time_step, test.relax_steps);
    SampleOnStand sample(assembly, test.time_step);
    const double response = servo_response * grains.slowness;
    StressServo x(grains.modulus, response, 0, test.rate), y = x;
    std::vector<ElementRow> rows{sample.row()};
    // The pressure counts as reached when it has stayed for ten response times.
    const int hold = static_cast<int>(10 * response / test.time_step);
    for (int held = 0; held < hold;) {
        const int steps = drive(sample, x, y, test);
        held = at_pressure(assembly.stress(), test) ? held + steps : 0;
        if (sample.steps() % test.sample_every < steps) rows.push_back(sample.row());
        if (sample.steps() > test.max_steps)
            throw std::runtime_error(
                fmt::format("isotropic test: {:g} Pa not reached in {} steps (now {:g} and {:g} Pa)",
                            test.pressure, sample.steps(), assembly.stress()(0, 0), assembly.stress()(1, 1)));
    }
    if (rows.back().step != sample.steps()) rows.push_back(sample.row());
    return rows;
}

void compress(Assembly& sample, IsotropicTest test, const GrainScale& grains) {
    test.sample_every = static_cast<int>(test.max_steps);
    run_isotropic(sample, test, grains);
}

}  // namespace sandgraph::dem

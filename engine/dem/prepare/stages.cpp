#include "dem/prepare/stages.hpp"

#include <algorithm>
#include <cmath>

#include "base/contracts.hpp"
#include "dem/element_test/servo.hpp"

namespace sandgraph::dem {
namespace {

constexpr int servo_interval = 10;       // steps
constexpr double servo_response = 5e-4;  // of Table 1 grains [s]
constexpr int hold = 1000;               // steps within the tolerance before a pressure counts as reached
constexpr int relax_interval = 500;      // steps

double horizontal(const PressureStage& stage) { return stage.k0 * stage.pressure; }

Mat2 servo_gradient(const Mat2& stress, const PressureStage& stage) {
    const double modulus = stage.grains.modulus, response = servo_response * stage.grains.slowness;
    StressServo normal(modulus, response, 0, stage.rate), shear(0.5 * modulus, response, 0, stage.rate);
    Mat2 L = Mat2::Zero();
    L(0, 0) = -normal.rate(horizontal(stage) - stress(0, 0), 0);
    L(1, 1) = -normal.rate(stage.pressure - stress(1, 1), 0);
    if (stage.release_shear) L(0, 1) = L(1, 0) = 0.5 * shear.rate(0.5 * (stress(0, 1) + stress(1, 0)), 0);
    return L;
}

double progress_of(const Mat2& stress, const PressureStage& stage) {
    const double p = 0.5 * stress.trace(), target = 0.5 * (horizontal(stage) + stage.pressure);
    return p <= target ? p / target : target / p;
}

}  // namespace

double largest_rate(const PressureStage& stage) {
    const double response = servo_response * stage.grains.slowness;
    return std::min(stage.rate, stage.pressure / (stage.grains.modulus * response));
}

bool at_pressure(const Mat2& stress, const PressureStage& stage) {
    const double allowed = stage.tolerance * stage.pressure;
    const bool normal = std::abs(stress(0, 0) - horizontal(stage)) < allowed &&
                        std::abs(stress(1, 1) - stage.pressure) < allowed;
    return normal && (!stage.release_shear || std::abs(0.5 * (stress(0, 1) + stress(1, 0))) < allowed);
}

bool drive_to_pressure(Assembly& assembly, const PressureStage& stage, long max_steps,
                       const ProgressCallback& progress) {
    SG_EXPECT(stage.pressure > 0 && stage.k0 > 0 && stage.tolerance > 0 && stage.rate > 0);
    SG_EXPECT(stage.grains.modulus > 0 && stage.dt > 0);
    assembly.step(Mat2::Zero(), stage.dt, 1);  // an assembly may know its stress only from a step on
    int held = 0;
    for (long step = 0; step < max_steps; step += servo_interval) {
        const Mat2 stress = assembly.stress();
        held = at_pressure(stress, stage) ? held + servo_interval : 0;
        if (held > hold) return true;
        if (progress && step % 10'000 == 0) progress("to pressure", progress_of(stress, stage));
        assembly.step(servo_gradient(stress, stage), stage.dt, servo_interval);
    }
    return false;
}

bool relax(Assembly& assembly, double unbalanced, double dt, long max_steps) {
    SG_EXPECT(unbalanced > 0 && dt > 0);
    for (long step = 0; step < max_steps; step += relax_interval) {
        assembly.step(Mat2::Zero(), dt, relax_interval);
        if (assembly.observe().unbalanced < unbalanced) return true;
    }
    return false;
}

Packing at_rest(Packing packing) {
    packing.vx.clear();
    packing.vy.clear();
    packing.spin.clear();
    packing.L.setZero();
    return packing;
}

}  // namespace sandgraph::dem

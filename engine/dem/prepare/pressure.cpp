#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "base/contracts.hpp"
#include "base/error.hpp"
#include "dem/element_test/element_test.hpp"
#include "dem/prepare/prepare.hpp"
#include "dem/prepare/stages.hpp"
#include "dem/time_step.hpp"

namespace sandgraph::dem {
namespace {

constexpr int rounds = 20;        // servo and relaxation in turn
constexpr double round_time = 4;  // [s]
constexpr double at_rest_unbalanced = 1e-5;

PressureStage stage_of(const PressureTarget& target, const Packing& packing, const Material& material) {
    PressureStage stage;
    stage.pressure = target.pressure;
    stage.tolerance = 0.5 * target.tolerance;  // relaxation then has room to drift
    stage.rate = target.rate;
    stage.modulus = typical_modulus(packing, material);
    stage.dt = target.dt > 0 ? target.dt : preparation_time_step(material, packing.r);
    stage.release_shear = true;
    return stage;
}

void check(const PressureTarget& target) {
    if (!(target.pressure > 0))
        throw InputError({"pressure", 0}, fmt::format("{:g} Pa", target.pressure),
                         "a packing needs confinement to hold", "give a positive pressure, e.g. 500 Pa");
}

}  // namespace

Packing compress_to(const Packing& packing, const PressureTarget& target, const Material& material,
                    const AssemblyFactory& factory, const ProgressCallback& progress) {
    check(target);
    SG_EXPECT(factory && target.tolerance > 0 && target.rate > 0 && target.dt >= 0);
    const auto assembly = factory(packing, calm(material));
    const PressureStage stage = stage_of(target, packing, material);
    PressureStage accepted = stage;
    accepted.tolerance = target.tolerance;
    const long steps_per_round = std::lround(round_time / stage.dt);
    for (int round = 0; round < rounds; ++round) {
        drive_to_pressure(*assembly, stage, steps_per_round, progress);
        const bool still = relax(*assembly, at_rest_unbalanced, stage.dt, steps_per_round);
        if (still && at_pressure(assembly->stress(), accepted)) return at_rest(assembly->packing());
    }
    throw std::runtime_error(fmt::format("packing does not come to rest at {:g} Pa (now {:g} and {:g} Pa)",
                                         target.pressure, assembly->stress()(0, 0),
                                         assembly->stress()(1, 1)));
}

}  // namespace sandgraph::dem

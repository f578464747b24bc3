#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "base/contracts.hpp"
#include "base/error.hpp"
#include "dem/packing/packing.hpp"
#include "dem/prepare/prepare.hpp"
#include "dem/prepare/stages.hpp"

namespace sandgraph::dem {
namespace {

constexpr int rounds = 20;          // servo and relaxation in turn
constexpr double round_time = 4;    // of Table 1 grains [s]
constexpr double sheared_time = 1;  // the same where grains may flow: a tenth of strain each way
constexpr double usual_rate = 0.1;  // of Table 1 grains [1/s]
constexpr double at_rest_unbalanced = 1e-5;
constexpr double flowing = 0.1;  // deviatoric strain past which grains flow and are not consolidated

PressureStage stage_of(const PressureTarget& target, const Packing& packing, const Material& material) {
    PressureStage stage;
    stage.pressure = target.pressure;
    stage.k0 = target.k0;
    stage.tolerance = 0.5 * target.tolerance;  // relaxation then has room to drift
    stage.grains = grain_scale(packing, material);
    stage.rate = target.rate > 0 ? target.rate : usual_rate / stage.grains.slowness;
    stage.dt = target.dt > 0 ? target.dt : stage.grains.time_step;
    stage.release_shear = true;
    return stage;
}

void check(const PressureTarget& target) {
    if (!(target.pressure > 0))
        throw InputError({"pressure", 0}, fmt::format("{:g} Pa", target.pressure),
                         "a packing needs confinement to hold", "give a positive pressure, e.g. 500 Pa");
}

[[noreturn]] void refuse_pressure(double pressure, const std::string& why, double bearable) {
    throw InputError({"pressure", 0}, fmt::format("{:g} kPa", pressure / 1e3), why,
                     fmt::format("write {:g} kPa or less, or stiffer grains (grains.young)", bearable / 1e3));
}

double mean_pressure(const PressureTarget& target) { return 0.5 * (1 + target.k0) * target.pressure; }

double deviatoric_strain(const Mat2& from, const Mat2& to) {
    return std::abs(std::log(to(0, 0) / from(0, 0)) - std::log(to(1, 1) / from(1, 1)));
}

[[noreturn]] void refuse_ratio(const PressureTarget& target) {
    throw InputError({"ground.k0", 0}, fmt::format("{:g}", target.k0),
                     fmt::format("the grains flow before they bear it at {:g} kPa", target.pressure / 1e3),
                     "write a value nearer to 1");
}

}  // namespace

double bearable_pressure(const GrainScale& grains) { return 0.15 * grains.modulus; }

void check_bearable(double pressure, const GrainScale& grains) {
    const double most = bearable_pressure(grains);
    if (pressure > most)
        refuse_pressure(
            pressure, fmt::format("it presses the grains into each other, which bear {:.3g} kPa", most / 1e3),
            most);
}

void check_uncrushed(const Packing& packing, double pressure) {
    const auto refuse = [&](const std::string& why) {
        refuse_pressure(pressure, "these grains do not bear it: " + why, 0.5 * pressure);
    };
    if (const double pores = porosity(packing); !(pores > 0)) refuse(fmt::format("porosity {:.3f}", pores));
    try {
        check_packing(packing, {"packing", 0, {}});
    } catch (const InputError& crushed) {
        refuse(crushed.what());
    }
}

Packing compress_to(const Packing& packing, const PressureTarget& target, const Material& material,
                    const AssemblyFactory& factory, const ProgressCallback& progress) {
    check(target);
    check_bearable(mean_pressure(target), grain_scale(packing, material));
    SG_EXPECT(factory && target.tolerance > 0 && target.rate >= 0 && target.dt >= 0);
    const auto assembly = factory(packing, calm(material));
    const PressureStage stage = stage_of(target, packing, material);
    PressureStage accepted = stage;
    accepted.tolerance = target.tolerance;
    const long steps_per_round =
        std::lround((target.k0 == 1 ? round_time : sheared_time) * stage.grains.slowness / stage.dt);
    for (int round = 0; round < rounds; ++round) {
        drive_to_pressure(*assembly, stage, steps_per_round, progress);
        if (target.k0 != 1 && deviatoric_strain(packing.H, assembly->cell()) > flowing) refuse_ratio(target);
        const bool still = relax(*assembly, at_rest_unbalanced, stage.dt, steps_per_round);
        if (!still || !at_pressure(assembly->stress(), accepted)) continue;
        const Packing made = at_rest(assembly->packing());
        check_uncrushed(made, mean_pressure(target));
        return made;
    }
    if (target.k0 != 1) refuse_ratio(target);
    throw std::runtime_error(fmt::format("packing does not come to rest at {:g} Pa (now {:g} and {:g} Pa)",
                                         target.pressure, assembly->stress()(0, 0),
                                         assembly->stress()(1, 1)));
}

}  // namespace sandgraph::dem

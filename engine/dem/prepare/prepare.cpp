#include "dem/prepare/prepare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/contracts.hpp"
#include "base/error.hpp"
#include "dem/grain_scale.hpp"
#include "dem/prepare/stages.hpp"

namespace sandgraph::dem {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double largest_friction = 40 * degree;
constexpr int most_trials = 30;
constexpr long consolidation_steps = 1'000'000;  // for usual grains
constexpr double gas_strain = 1;                 // of each side, more than a gas needs to jam

// Of the recipe, not of a packing: the radii drawn are some of those between.
GrainScale scale_of(const Recipe& recipe, const Material& material) {
    return grain_scale(std::array{recipe.radius_min, recipe.radius_max}, material);
}

PressureStage stage_of(const Recipe& recipe, const Packing& packing, const Material& material) {
    PressureStage stage;
    stage.pressure = recipe.consolidation_pressure;
    stage.grains = grain_scale(packing, material);
    stage.rate = recipe.rate / stage.grains.slowness;
    stage.dt = scale_of(recipe, material).time_step;
    return stage;
}

// The servo closes the gas at p/(M response) at most: slowly for stiff grains.
long enough_steps(const PressureStage& stage) {
    const double steps = gas_strain / (largest_rate(stage) * stage.dt);
    return std::max(consolidation_steps, static_cast<long>(steps));
}

[[noreturn]] void refuse_endless(const Recipe& recipe, const Material& material) {
    constexpr double usual_damping = Material{}.damping;
    const std::string why =
        fmt::format("consolidation to {:g} kPa does not end", recipe.consolidation_pressure / 1e3);
    if (material.damping < usual_damping)
        throw InputError({"recipe", 0}, fmt::format("grains.damping = {:g}", material.damping),
                         why + ": the grains ring on", fmt::format("write {:g}", usual_damping));
    throw InputError({"recipe", 0}, why, "the grains never come to rest at this pressure",
                     "take another grains.seed or more grains (grains.count)");
}

Packing consolidate(const Recipe& recipe, const Packing& gas, Material material, double friction,
                    const AssemblyFactory& factory, const ProgressCallback& progress) {
    SG_EXPECT(friction >= 0 && friction <= largest_friction);
    material.friction_angle = friction;
    const auto assembly = factory(gas, material);
    const PressureStage stage = stage_of(recipe, gas, material);
    if (!drive_to_pressure(*assembly, stage, enough_steps(stage), progress)) refuse_endless(recipe, material);
    return at_rest(assembly->packing());
}

Packing rebalance(const Recipe& recipe, const Packing& packing, const Material& material,
                  const AssemblyFactory& factory, const ProgressCallback& progress) {
    PressureTarget target;
    target.pressure = recipe.consolidation_pressure;
    const GrainScale grains = scale_of(recipe, material);
    target.rate = recipe.rate / grains.slowness;
    target.dt = grains.time_step;
    return compress_to(packing, target, material, factory, progress);
}

// Porosity against consolidation friction scatters by 0.003 from gas to gas around 0.155 + 0.0093
// (phi/deg)^0.6, so the friction is found by stochastic approximation (Robbins & Monro 1951) in t =
// (phi/deg)^0.6, a new gas a trial.
class FrictionSearch {
  public:
    explicit FrictionSearch(double target) : target_(target), t_(std::max(0.0, (target - 0.155) / slope)) {}
    double friction() const { return std::min(std::pow(t_, 1 / 0.6) * degree, largest_friction); }
    void learn(double found) { t_ = std::max(0.0, t_ + (target_ - found) / (slope * (1 + 0.5 * trials_++))); }

  private:
    static constexpr double slope = 0.0093;
    double target_, t_;
    int trials_ = 0;
};

struct Preparation {
    const Recipe& recipe;
    const Material& material;
    const AssemblyFactory& factory;
    const ProgressCallback& progress;
    Prepared result;

    bool on_target() const { return std::abs(result.porosity - recipe.target_porosity) <= recipe.tolerance; }
    void run(const Packing& gas, double friction) {
        const Packing dense = consolidate(recipe, gas, material, friction, factory, progress);
        result.packing = rebalance(recipe, dense, material, factory, progress);
        result.porosity = porosity(result.packing);
        result.consolidation_friction = friction;
        ++result.trials;
        if (progress)
            progress(fmt::format("porosity {:.4f} with {:.2f} deg", result.porosity, friction / degree), 1);
    }
};

}  // namespace

Prepared prepare(const Recipe& recipe, const Material& material, const AssemblyFactory& factory,
                 const ProgressCallback& progress) {
    SG_EXPECT(factory);
    check_bearable(recipe.consolidation_pressure, scale_of(recipe, material));
    Preparation preparation{recipe, material, factory, progress, {}};
    FrictionSearch search(recipe.target_porosity);
    for (int trial = 0; trial < most_trials; ++trial) {
        preparation.run(random_gas(recipe, trial), search.friction());
        if (preparation.on_target()) return preparation.result;
        search.learn(preparation.result.porosity);
    }
    throw InputError({"recipe", 0}, fmt::format("porosity {:g} is out of reach", recipe.target_porosity),
                     fmt::format("the last of {} consolidations gave {:.4f}", preparation.result.trials,
                                 preparation.result.porosity),
                     "choose 0.16 (dense) to 0.21 (loose), or a wider tolerance");
}

}  // namespace sandgraph::dem

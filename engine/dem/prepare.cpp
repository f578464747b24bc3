#include "dem/prepare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/error.hpp"
#include "dem/element_test.hpp"
#include "dem/prepare_stages.hpp"

namespace sandgraph::dem {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double largest_friction = 40 * degree;
constexpr int gases = 8, trials_per_gas = 10;
constexpr long consolidation_steps = 1'000'000;

PressureStage stage_of(const Recipe& recipe, const Packing& packing, const Material& material) {
    PressureStage stage;
    stage.pressure = recipe.pressure;
    stage.rate = recipe.rate;
    stage.modulus = typical_modulus(packing, material);
    stage.dt = recipe.dt;
    return stage;
}

Packing consolidate(const Recipe& recipe, const Packing& gas, Material material, double friction,
                    const AssemblyFactory& factory, const Progress& progress) {
    material.friction_angle = friction;
    const auto assembly = factory(gas, material);
    if (!drive_to_pressure(*assembly, stage_of(recipe, gas, material), consolidation_steps, progress))
        throw std::runtime_error(fmt::format("consolidation to {:g} Pa does not end", recipe.pressure));
    return at_rest(assembly->packing());
}

Packing rebalance(const Recipe& recipe, const Packing& packing, const Material& material,
                  const AssemblyFactory& factory, const Progress& progress) {
    PressureTarget target;
    target.pressure = recipe.pressure;
    target.rate = recipe.rate;
    target.dt = recipe.dt;
    return compress_to(packing, target, material, factory, progress);
}

// Bisection on a noisy, on the whole rising function: porosity against consolidation friction.
struct FrictionSearch {
    double low = 0, high = largest_friction;
    double next;
    explicit FrictionSearch(double porosity) : next(first_guess(porosity)) {}

    // About 0.16 without friction, 0.20 at 13 deg.
    static double first_guess(double porosity) {
        return std::clamp((porosity - 0.16) / 0.04 * 13 * degree, 0.0, 30 * degree);
    }
    // False when even frictionless grains come out too loose.
    bool learn(double found, double target) {
        if (found > target && next == 0) return false;
        (found < target ? low : high) = next;
        next = high < 1 * degree && low == 0 ? 0 : 0.5 * (low + high);
        return true;
    }
};

struct Preparation {
    const Recipe& recipe;
    const Material& material;
    const AssemblyFactory& factory;
    const Progress& progress;
    Prepared result;

    bool on_target() const { return std::abs(result.porosity - recipe.porosity) <= recipe.tolerance; }
    void run(const Packing& gas, double friction) {
        const Packing dense = consolidate(recipe, gas, material, friction, factory, progress);
        result.packing = rebalance(recipe, dense, material, factory, progress);
        result.porosity = porosity(result.packing);
        result.consolidation_friction = friction;
        ++result.trials;
        if (progress)
            progress(fmt::format("porosity {:.4f} with {:.2f} deg", result.porosity, friction / degree), 1);
    }
    bool try_gas(const Packing& gas) {
        FrictionSearch search(recipe.porosity);
        for (int k = 0; k < trials_per_gas; ++k) {
            run(gas, search.next);
            if (on_target()) return true;
            if (!search.learn(result.porosity, recipe.porosity)) return false;
        }
        return false;
    }
};

}  // namespace

Prepared prepare(const Recipe& recipe, const Material& material, const AssemblyFactory& factory,
                 const Progress& progress) {
    Preparation preparation{recipe, material, factory, progress, {}};
    for (int attempt = 0; attempt < gases; ++attempt)
        if (preparation.try_gas(random_gas(recipe, attempt))) return preparation.result;
    throw InputError({"recipe", 0}, fmt::format("porosity {:g} is out of reach", recipe.porosity),
                     fmt::format("the last of {} consolidations gave {:.4f}", preparation.result.trials,
                                 preparation.result.porosity),
                     "choose 0.16 (dense) to 0.21 (loose), or a wider tolerance");
}

}  // namespace sandgraph::dem

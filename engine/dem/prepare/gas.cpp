#include <fmt/format.h>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

#include "base/contracts.hpp"
#include "base/error.hpp"
#include "base/random.hpp"
#include "dem/prepare/prepare.hpp"

namespace sandgraph::dem {
namespace {

enum Stream : std::uint64_t { radii_stream = 1, places_stream = 2 };  // attempts go on from places_stream
constexpr int tries_per_disk = 20'000;

std::vector<double> draw_radii(const Recipe& recipe) {
    Random random(recipe.seed, radii_stream);
    std::vector<double> r(static_cast<std::size_t>(recipe.count));
    for (double& value : r) value = random.uniform(recipe.radius_min, recipe.radius_max);
    std::sort(r.begin(), r.end(), std::greater<>());  // small disks fit in late
    return r;
}

double nearest_image(double d, double side) { return d - side * std::round(d / side); }

bool is_free(const Packing& p, double x, double y, double r, double side) {
    for (std::size_t g = 0; g < p.x.size(); ++g)
        if (std::hypot(nearest_image(x - p.x[g], side), nearest_image(y - p.y[g], side)) < r + p.r[g])
            return false;
    return true;
}

bool place(Packing& p, double r, double side, Random& random) {
    for (int k = 0; k < tries_per_disk; ++k) {
        const double x = random.uniform(0, side), y = random.uniform(0, side);
        if (!is_free(p, x, y, r, side)) continue;
        p.x.push_back(x), p.y.push_back(y), p.r.push_back(r);
        return true;
    }
    return false;
}

void check(const Recipe& recipe) {
    const InputError::Where where{"recipe", 0};
    if (recipe.count < fewest_grains)
        throw InputError(where, fmt::format("count = {}", recipe.count), "too few for a packing", "use 400");
    if (!(recipe.radius_min > 0) || !(recipe.radius_max >= recipe.radius_min))
        throw InputError(where, fmt::format("radii {:g} to {:g} m", recipe.radius_min, recipe.radius_max),
                         "0 < radius_min <= radius_max is needed", "use 0.003 and 0.007");
    if (!(recipe.gas_porosity > recipe.target_porosity) || !(recipe.gas_porosity < 1))
        throw InputError(where, fmt::format("gas_porosity = {:g}", recipe.gas_porosity),
                         "a gas is looser than the packing made from it", "use 0.45");
    if (!(recipe.target_porosity > 0) || !(recipe.tolerance > 0))
        throw InputError(where,
                         fmt::format("porosity = {:g} +- {:g}", recipe.target_porosity, recipe.tolerance),
                         "both must be positive", "use 0.16 or 0.20 and 0.002");
    if (!(recipe.consolidation_pressure > 0) || !(recipe.rate > 0))
        throw InputError(
            where, fmt::format("pressure {:g} Pa, rate {:g} 1/s", recipe.consolidation_pressure, recipe.rate),
            "both must be positive", "use 10 kPa, 1 1/s");
}

}  // namespace

// When a disk finds no place, the whole gas is drawn again in a cell 2 % larger.
Packing random_gas(const Recipe& recipe, int attempt) {
    SG_EXPECT(attempt >= 0);
    check(recipe);
    const std::vector<double> radii = draw_radii(recipe);
    Random random(recipe.seed, places_stream + static_cast<std::uint64_t>(attempt));
    double solid = 0;
    for (double r : radii) solid += std::numbers::pi * r * r;
    for (double side = std::sqrt(solid / (1 - recipe.gas_porosity));; side *= 1.02) {
        Packing gas;
        gas.H = side * Mat2::Identity();
        if (std::ranges::all_of(radii, [&](double r) { return place(gas, r, side, random); })) return gas;
    }
}

}  // namespace sandgraph::dem

#include "dem/grain_scale.hpp"

#include <cmath>
#include <numeric>

#include "base/contracts.hpp"
#include "dem/packing/packing.hpp"
#include "dem/prepare/recipe.hpp"
#include "dem/time_step.hpp"

namespace sandgraph::dem {
namespace {

double mean_radius(std::span<const double> radii) {
    SG_EXPECT(!radii.empty());
    return std::accumulate(radii.begin(), radii.end(), 0.0) / static_cast<double>(radii.size());
}

double modulus(double radius, const Material& m) {
    SG_EXPECT(m.depth > 0);
    return 0.5 * m.young * radius / m.depth;
}

double vibration(double radius, const Material& m) {
    return 2 * radius * std::sqrt(m.density / modulus(radius, m));
}

constexpr double preparation_share = 0.4;  // the usual step is 0.39 of the limit of Table 1 grains

}  // namespace

GrainScale grain_scale(std::span<const double> radii, const Material& material) {
    const Material usual;
    const Recipe recipe;
    const double radius = mean_radius(radii), usual_radius = 0.5 * (recipe.radius_min + recipe.radius_max);
    GrainScale scale;
    scale.diameter = 2 * radius, scale.density = material.density;
    scale.modulus = modulus(radius, material);
    scale.slowness = unless_near_one(vibration(radius, material) / vibration(usual_radius, usual));
    scale.stiffness = unless_near_one(scale.modulus / modulus(usual_radius, usual));
    scale.time_step =
        std::min(usual_time_step * scale.slowness, preparation_share * critical_time_step(material, radii));
    return scale;
}

GrainScale grain_scale(const Packing& packing, const Material& material) {
    return grain_scale(packing.r, material);
}

double inertial_number(double rate, double p, const GrainScale& grains) {
    return p > 0 ? rate * grains.diameter * std::sqrt(grains.density / p) : 0;
}

}  // namespace sandgraph::dem

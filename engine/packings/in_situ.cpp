#include "packings/in_situ.hpp"

#include <tbb/parallel_for.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/console.hpp"
#include "base/error.hpp"
#include "packings/sand_sample.hpp"
#include "scene/alignment.hpp"

namespace sandgraph::packings {
namespace {

std::vector<double> in_situ(const scene::Scene& scene, double density) {
    const double spacing = scene::point_spacing(scene.domain);
    const auto rows = static_cast<int>(std::lround(scene.domain.depth / spacing));
    std::vector<double> out;
    out.reserve(static_cast<std::size_t>(rows));
    for (int row = 0; row < rows; ++row)
        out.push_back(scene.ground.surcharge + density * scene.ground.gravity * (row + 0.5) * spacing);
    return out;
}

// Between the active and the passive stress of the weakest packing (Rankine), or its grains would flow.
void require_holding(const scene::Scene& scene, const std::vector<double>& angles) {
    const double s = std::sin(*std::ranges::min_element(angles)), k0 = scene.ground.k0;
    const double active = (1 - s) / (1 + s), passive = 1 / active;
    if (k0 >= active && k0 <= passive) return;
    throw InputError(
        scene.where("ground.k0"), fmt::format("ground.k0 = {:g}", k0),
        fmt::format("the sand would flow: its peak friction of {:.1f} deg holds {:.3f} to {:.3f}",
                    std::asin(s) * 180 / std::numbers::pi, active, passive),
        "write a value between");
}

void make_packings(const SandSample& sand, double k0, PreparedGround& ground,
                   const ProgressCallback& progress) {
    ground.packings.resize(ground.row_pressure.size() * sand.size());
    Tally tally(ground.packings.size(), progress);
    tbb::parallel_for(std::size_t{0}, ground.packings.size(), [&](std::size_t k) {
        const std::size_t row = k / sand.size(), sample = k % sand.size();
        ground.packings[k] = sand[sample].row(ground.row_pressure[row], k0);
        tally.done("in-situ packings");
    });
}

// Peak friction of the packings in use, `angles` [rad], and of their sand; what is known of each packing.
void describe(const SandSample& sand, const scene::Grains& grains, const std::vector<double>& angles,
              PreparedGround& ground, const ProgressCallback& progress) {
    ground.friction_angle = friction_sample(angles).mean;
    ground.friction = sampled_friction(grains, angles, progress);
    for (std::size_t k = 0; k < ground.packings.size(); ++k) {
        const std::size_t sample = k % sand.size();
        ground.traits.push_back(sand[sample].traits(ground.packings[k], angles[sample]));
    }
}

}  // namespace

std::vector<double> PreparedGround::radii() const {
    const std::size_t samples = packings.size() / row_pressure.size();
    std::vector<double> out;
    for (std::size_t k = 0; k < samples; ++k) {
        const std::vector<double>& radius = packings[k].packing->grains->radius;
        out.insert(out.end(), radius.begin(), radius.end());
    }
    return out;
}

PreparedGround prepare_ground(const scene::Scene& scene, const ProgressCallback& progress) {
    PreparedGround ground;
    const scene::Continuum& law = scene.ground.continuum;
    if (scene.ground.law != scene::Law::rve) {
        ground.density = law.density;
        ground.friction_angle = scene.ground.law == scene::Law::mohr_coulomb ? law.friction_angle : 0;
        ground.friction.mean = ground.friction_angle;
        ground.row_pressure = in_situ(scene, ground.density);
        return ground;
    }
    const scene::Grains& grains = scene.ground.grains;
    const SandSample sand(grains, progress);
    // docs/how_it_works.md (eq. 1). One density for the whole ground, that of the packings at mid-depth: it
    // varies by a few tenths of a per cent with depth, and a uniform one keeps rows and weight in exact
    // equilibrium.
    const double guess = grains.material.density * (1 - sand.porosity());
    const std::vector<double> first = in_situ(scene, guess);
    const double k0 = scene.ground.k0;
    // The first row is the deepest or the last is: no order is taken for granted.
    for (std::size_t sample = 0; sample < sand.size(); ++sample)
        dem::check_bearable(0.5 * (1 + k0) * *std::ranges::max_element(first),
                            dem::grain_scale(sand[sample].base_packing(), grains.material));
    const std::vector<double> angles = sand.friction(progress);
    require_holding(scene, angles);
    const double porosity = sand.porosity(first[first.size() / 2], k0);
    ground.density = grains.material.density * (1 - porosity);
    ground.row_pressure = in_situ(scene, ground.density);
    make_packings(sand, k0, ground, progress);
    describe(sand, grains, angles, ground, progress);
    return ground;
}

}  // namespace sandgraph::packings

#include "packings/in_situ.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "base/console.hpp"
#include "packings/compressed_packings.hpp"
#include "scene/check_scene.hpp"

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

void make_rows(const CompressedPackings& packings, PreparedGround& ground, const ProgressCallback& progress) {
    ground.rows.resize(ground.row_pressure.size());
    Tally tally(ground.rows.size(), progress);
    tbb::parallel_for(std::size_t{0}, ground.rows.size(), [&](std::size_t row) {
        ground.rows[row] = packings.row(ground.row_pressure[row]);
        tally.done("in-situ packings");
    });
}

}  // namespace

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
    const CompressedPackings packings(grains, progress);
    // docs/how_it_works.md (eq. 1). One density for the whole ground, that of the packing at mid-depth: it
    // varies by a few tenths of a per cent with depth, and a uniform one keeps rows and weight in exact
    // equilibrium.
    const double guess = grains.material.density * (1 - dem::porosity(packings.base_packing()));
    const std::vector<double> first = in_situ(scene, guess);
    // The first row is the deepest or the last is: no order is taken for granted.
    dem::check_bearable(*std::ranges::max_element(first),
                        dem::grain_scale(packings.base_packing(), grains.material));
    const double porosity = dem::porosity(packings.at(first[first.size() / 2]));
    ground.density = grains.material.density * (1 - porosity);
    ground.row_pressure = in_situ(scene, ground.density);
    make_rows(packings, ground, progress);
    ground.friction_angle = packings.friction(progress);
    ground.friction = sampled_friction(grains, ground.friction_angle, progress);
    for (const graph::RowPacking& row : ground.rows)
        ground.traits.push_back(packings.traits(row, ground.friction_angle));
    return ground;
}

}  // namespace sandgraph::packings

#include "app/prepare_ground.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <cmath>
#include <mutex>

#include "app/measure_friction.hpp"
#include "app/packing_cache.hpp"
#include "app/prepare_packing.hpp"
#include "dem/observe.hpp"
#include "scene/check_scene.hpp"

namespace sandgraph::app {
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

// The same grains at another pressure, cached by the pressure's exact value.
class Compressed {
  public:
    Compressed(const scene::Grains& grains, const dem::Progress& progress)
        : material_(grains.material), recipe_(packing_recipe(grains)), base_(base(grains, progress)) {}

    dem::Packing at(double pressure) const {
        return cached_packing(fmt::format("{}pressure = {:a}\n", recipe_, pressure), material_, [&] {
            return dem::compress_to(base_, {.pressure = pressure}, material_, fast_assemblies());
        });
    }
    graph::RowPacking row(double pressure) const {
        const dem::Packing packing = at(pressure);
        const Mat2 stress =
            dem::love_weber_stress(packing, dem::contact_forces(packing, material_), material_);
        return {dem::compact(packing, material_, stress), moduli(packing, pressure)};
    }
    graph::PlaneModuli moduli(const dem::Packing& packing, double pressure) const {
        const auto value = cached_numbers(fmt::format("{}moduli at {:a}\n", recipe_, pressure), 2, [&] {
            const dem::Moduli m = dem::small_strain_moduli(packing, material_, fast_assemblies());
            return std::vector<double>{m.bulk, m.shear};
        });
        return {value[0], value[1]};
    }
    const dem::Packing& base_packing() const { return base_; }
    const std::string& recipe() const { return recipe_; }

  private:
    dem::Packing base(const scene::Grains& grains, const dem::Progress& progress) const {
        return cached_packing(recipe_ + "base\n", material_,
                              [&] { return app::base_packing(grains, progress); });
    }
    dem::Material material_;
    std::string recipe_;
    dem::Packing base_;
};

void make_rows(const Compressed& packings, PreparedGround& ground, const dem::Progress& progress) {
    ground.rows.resize(ground.row_pressure.size());
    std::atomic<int> done{0};
    std::mutex telling;
    tbb::parallel_for(std::size_t{0}, ground.rows.size(), [&](std::size_t row) {
        ground.rows[row] = packings.row(ground.row_pressure[row]);
        const std::lock_guard lock(telling);
        if (progress) progress("packing of each depth", ++done / static_cast<double>(ground.rows.size()));
    });
}

}  // namespace

PreparedGround prepare_ground(const scene::Scene& scene, const dem::Progress& progress) {
    PreparedGround ground;
    const scene::Continuum& law = scene.ground.continuum;
    if (scene.ground.law != scene::Law::rve) {
        ground.density = law.density;
        ground.friction_angle = scene.ground.law == scene::Law::mohr_coulomb ? law.friction_angle : 0;
        ground.row_pressure = in_situ(scene, ground.density);
        return ground;
    }
    const scene::Grains& grains = scene.ground.grains;
    const Compressed packings(grains, progress);
    // One density for the whole ground, that of the packing at mid-depth: it varies by a few tenths of a per
    // cent with depth, and a uniform one keeps rows and weight in exact equilibrium.
    const double guess = grains.material.density * (1 - dem::porosity(packings.base_packing()));
    const std::vector<double> first = in_situ(scene, guess);
    const double porosity = dem::porosity(packings.at(first[first.size() / 2]));
    ground.density = grains.material.density * (1 - porosity);
    ground.row_pressure = in_situ(scene, ground.density);
    make_rows(packings, ground, progress);
    ground.friction_angle =
        measured_friction(packings.base_packing(), grains.material, packings.recipe(), progress);
    return ground;
}

}  // namespace sandgraph::app

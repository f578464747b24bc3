#include "packings/compressed_packings.hpp"

#include <fmt/format.h>

#include <cmath>

#include "dem/make_assembly.hpp"
#include "dem/packing/observe.hpp"
#include "packings/base_packing.hpp"
#include "packings/cache.hpp"
#include "packings/friction.hpp"

namespace sandgraph::packings {

namespace {

// The text that tells it from other stresses.
std::string text_of(double pressure, double k0) {
    return k0 == 1 ? fmt::format("{:a}", pressure) : fmt::format("{:a}, k0 = {:a}", pressure, k0);
}

}  // namespace

CompressedPackings::CompressedPackings(const scene::Grains& grains, const ProgressCallback& progress)
    : material_(grains.material),
      recipe_(packing_recipe(grains)),
      base_(cached_packing(recipe_ + "base\n", material_,
                           [&] { return packings::base_packing(grains, progress); })) {}

dem::Packing CompressedPackings::at(double pressure, double k0) const {
    const std::string recipe = fmt::format("{}pressure = {}\n", recipe_, text_of(pressure, k0));
    return cached_packing(recipe, material_, [&] {
        return dem::compress_to(base_, {.pressure = pressure, .k0 = k0}, material_, dem::fast_assemblies());
    });
}

graph::RowPacking CompressedPackings::row(double pressure, double k0) const {
    const dem::Packing packing = at(pressure, k0);
    const Mat2 stress = dem::love_weber_stress(packing, dem::contact_forces(packing, material_), material_);
    return {dem::compact(packing, material_, stress), moduli(packing, text_of(pressure, k0))};
}

graph::PlaneModuli CompressedPackings::moduli(const dem::Packing& packing, const std::string& stress) const {
    const auto value = cached_numbers(fmt::format("{}moduli at {}\n", recipe_, stress), 2, [&] {
        const dem::Moduli m = dem::small_strain_moduli(packing, material_, dem::fast_assemblies());
        return std::vector<double>{m.bulk, m.shear};
    });
    return {value[0], value[1]};
}

double CompressedPackings::friction(const ProgressCallback& progress) const {
    return measured_friction(base_, material_, recipe_, progress);
}

stress::PackingTraits CompressedPackings::traits(const graph::RowPacking& row, double friction_angle) const {
    const dem::Packing packing = dem::to_packing(*row.packing);
    const dem::Observables seen = dem::observe(packing, dem::contact_forces(packing, material_), material_);
    stress::PackingTraits traits;
    traits.pressure = 0.5 * seen.stress.trace();
    traits.porosity = seen.porosity;
    traits.bulk = row.moduli.bulk, traits.shear = row.moduli.shear;
    traits.coordination = seen.coordination;
    traits.fabric_xx = 0.5 * (seen.fabric(0, 0) - seen.fabric(1, 1));
    traits.fabric_xy = seen.fabric(0, 1);
    traits.peak_friction = std::sin(friction_angle);
    return traits;
}

}  // namespace sandgraph::packings

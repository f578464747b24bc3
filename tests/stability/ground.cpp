#include "stability/ground.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "graph/visits.hpp"
#include "mpm/audit.hpp"
#include "packings/compressed_packings.hpp"
#include "support/paths.hpp"
#include "surrogate/load_surrogate.hpp"

namespace sandgraph::stability {
namespace {

mpm::GridShape grid_of(const GroundSpec& s) {
    const auto cells = [&](double length) { return static_cast<int>(std::lround(length / s.cell)); };
    return {0, 0, s.cell, cells(s.soil.x1 + s.wide), cells(s.soil.y1 + s.room)};
}

double pressure_at(const GroundSpec& spec, double density, double depth) {
    return spec.pressure ? spec.pressure(depth) : spec.surcharge + density * gravity * depth;
}

graph::RveLawSetup grains_of(const GroundSpec& spec, const packings::CompressedPackings& packings,
                             const scene::Grains& recipe, const mpm::Points& points, double density) {
    graph::RveLawSetup setup;
    const int rows = points.row.empty() ? 0 : *std::ranges::max_element(points.row) + 1;
    for (int row = 0; row < rows; ++row) {
        const double depth = (row + 0.5) * 2 * points.half;
        setup.packings.push_back(packings.row(pressure_at(spec, density, depth)));
    }
    setup.material = recipe.material;
    setup.packing_of_point = points.row;
    setup.options = dem::rve_options({}, recipe.material, setup.packings.front().packing->grains->radius);
    if (spec.stepping) spec.stepping(setup.options);
    return setup;
}

std::unique_ptr<stress::Law> plastic_law(const GroundSpec& spec, const mpm::Points& points, double density) {
    std::vector<Stress> stress;
    std::vector<double> zz;
    for (const std::int32_t row : points.row) {
        const double p = pressure_at(spec, density, (row + 0.5) * 2 * points.half);
        stress.push_back({-p, -p, 0}), zz.push_back(-p);
    }
    return std::make_unique<stress::MohrCoulomb>(*spec.plastic, std::move(stress), std::move(zz));
}

std::unique_ptr<stress::Law> law_of(const GroundSpec& spec, const packings::CompressedPackings& packings,
                                    graph::RveLawSetup grains) {
    if (!spec.screening) return std::make_unique<graph::RveLaw>(std::move(grains));
    graph::ScreeningSetup setup;
    setup.surrogate =
        surrogate::load_surrogate(sandgraph::test::source_file("/configs/models/table1.surrogate.h5"));
    const double angle = packings.friction();
    for (const graph::RowPacking& row : grains.packings) setup.traits.push_back(packings.traits(row, angle));
    setup.grains = std::move(grains);
    spec.screening(setup);
    return std::make_unique<graph::ScreeningLaw>(std::move(setup));
}

mpm::RigidPlate plate_of(const GroundSpec& spec, double density) {
    const mpm::Rectangle& r = *spec.plate;
    mpm::RigidPlate plate;
    plate.x = 0.5 * (r.x0 + r.x1), plate.y = 0.5 * (r.y0 + r.y1);
    plate.half_width = 0.5 * (r.x1 - r.x0), plate.half_height = 0.5 * (r.y1 - r.y0);
    plate.friction_angle = std::numbers::pi / 2;
    plate.rest = mpm::rest_pressure(spec.surcharge, density * gravity, spec.soil.y1 - plate.y);
    return plate;
}

simulation::Spec simulation_spec(const GroundSpec& spec, double density) {
    simulation::Spec out;
    out.ground = {spec.soil, spec.per_cell, density, {}, {}, {}};
    out.grid = grid_of(spec), out.boundaries = spec.boundaries;
    out.gravity = {0, -gravity}, out.surcharge = spec.surcharge;
    out.scheme.courant = spec.courant, out.scheme.damping = spec.damping;
    out.stable = spec.plate.has_value();
    if (spec.plate) out.bodies = {{plate_of(spec, density), {}}};
    return out;
}

}  // namespace

Ground::Ground(const GroundSpec& spec) {
    scene::Grains recipe;
    recipe.count = spec.grains;
    const packings::CompressedPackings packings(recipe);
    density_ = recipe.material.density * (1 - dem::porosity(packings.base_packing()));
    simulation::Spec whole = simulation_spec(spec, density_);
    whole.law = [&](const mpm::Points& points) {
        return spec.plastic ? plastic_law(spec, points, density_)
                            : law_of(spec, packings, grains_of(spec, packings, recipe, points, density_));
    };
    simulation_ = std::make_unique<simulation::Simulation>(whole);
}

void Ground::step(const Vec2& plate_velocity) {
    simulation_->step(plate_velocity);
    if (has_plate()) plate_work_ += mpm::plate_work(body().plate, body().contact.reaction, dt());
}

double Ground::kinetic() const { return mpm::kinetic_energy(points()); }
double Ground::potential() const { return mpm::gravity_potential(points(), {0, -gravity}); }

const graph::RveCounters& Ground::counters() const {
    static const graph::RveCounters no_counters;
    const stress::Law* any = simulation_->state().law.get();
    if (const auto* law = dynamic_cast<const graph::ScreeningLaw*>(any)) return law->counters();
    if (!dynamic_cast<const graph::RveLaw*>(any)) return no_counters;
    return rves().counters();
}

double stress_drift(const mpm::Points& points, const std::vector<Stress>& before) {
    double worst = 0;
    for (std::size_t p = 0; p < before.size(); ++p)
        worst = std::max(worst, graph::norm(graph::difference(points.stress[p], before[p])) /
                                    graph::reference_pressure(before[p], 1000));
    return worst;
}

}  // namespace sandgraph::stability

#include "stability/ground.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "graph/step_phases.hpp"
#include "graph/visits.hpp"
#include "mpm/audit.hpp"
#include "mpm/layout.hpp"
#include "mpm/time_step.hpp"
#include "packings/compressed_packings.hpp"
#include "surrogate/load_surrogate.hpp"

namespace sandgraph::stability {
namespace {

mpm::GridShape grid_of(const GroundSpec& s) {
    const auto cells = [&](double length) { return static_cast<int>(std::lround(length / s.cell)); };
    return {0, 0, s.cell, cells(s.soil.x1 + s.wide), cells(s.soil.y1 + s.room)};
}

mpm::Points points_of(const GroundSpec& s, double density) {
    mpm::Layout layout{s.soil, s.cell, s.per_cell, density, {}};
    if (s.plate) layout.cavities = {*s.plate};
    return mpm::lay_out(layout);
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
        setup.rows.push_back(packings.row(pressure_at(spec, density, depth)));
    }
    setup.material = recipe.material;
    setup.row_of_point = points.row;
    setup.options = dem::rve_options({}, recipe.material, setup.rows.front().packing->grains->radius);
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
    setup.surrogate = surrogate::load_surrogate(SANDGRAPH_SOURCE "/configs/models/table1.surrogate.h5");
    const double angle = packings.friction();
    for (const graph::RowPacking& row : grains.rows) setup.traits.push_back(packings.traits(row, angle));
    setup.grains = std::move(grains);
    spec.screening(setup);
    return std::make_unique<graph::ScreeningLaw>(std::move(setup));
}

mpm::RigidPlate plate_of(const GroundSpec& spec, double modulus, double density) {
    const mpm::Rectangle& r = *spec.plate;
    mpm::RigidPlate plate;
    plate.x = 0.5 * (r.x0 + r.x1), plate.y = 0.5 * (r.y0 + r.y1);
    plate.half_width = 0.5 * (r.x1 - r.x0), plate.half_height = 0.5 * (r.y1 - r.y0);
    plate.friction_angle = std::numbers::pi / 2;
    plate.stiffness = mpm::contact_stiffness(1, modulus, spec.cell);
    const double gamma = density * gravity, p = spec.surcharge + gamma * (spec.soil.y1 - plate.y);
    plate.rest = {p, p, gamma, gamma};
    return plate;
}

}  // namespace

Ground::Ground(const GroundSpec& spec) {
    scene::Grains recipe;
    recipe.count = spec.grains;
    const packings::CompressedPackings packings(recipe);
    density_ = recipe.material.density * (1 - dem::porosity(packings.base_packing()));
    mpm::Points points = points_of(spec, density_);
    auto law = spec.plastic ? plastic_law(spec, points, density_)
                            : law_of(spec, packings, grains_of(spec, packings, recipe, points, density_));
    const double modulus = law->p_wave_modulus();
    graph::StepSettings settings;
    settings.dt = spec.plate ? mpm::time_step({.courant = spec.courant}, {spec.cell, modulus, density_})
                             : spec.courant * spec.cell * std::sqrt(density_ / modulus);
    settings.scheme.damping = spec.damping, settings.gravity = gravity;
    settings.surcharge = spec.surcharge, settings.boundaries = spec.boundaries;
    state_ = std::make_unique<graph::GroundState>(settings, std::move(points), grid_of(spec));
    if (spec.plate) state_->has_plate = true, state_->plate = plate_of(spec, modulus, density_);
    state_->law = std::move(law);
    state_->law->initialise(state_->batch());
    graph_ = std::make_unique<graph::StepGraph>(graph::step_phases(*state_));
}

void Ground::step(const Vec2& plate_velocity) {
    state_->plate.velocity = plate_velocity;
    state_->d_over_B = travelled_;
    graph_->run();
    time_ += dt(), travelled_ += dt() * plate_velocity.y();
    plate_work_ += mpm::plate_work(state_->plate, state_->contact.reaction, dt());
    if (!state_->status.good()) throw std::runtime_error("a point left the grid");
}

double Ground::kinetic() const { return mpm::kinetic_energy(state_->points); }
double Ground::potential() const { return mpm::gravity_potential(state_->points, {0, -gravity}); }

const graph::RveCounters& Ground::counters() const {
    static const graph::RveCounters no_counters;
    if (const auto* law = dynamic_cast<const graph::ScreeningLaw*>(state_->law.get())) return law->counters();
    if (!dynamic_cast<const graph::RveLaw*>(state_->law.get())) return no_counters;
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

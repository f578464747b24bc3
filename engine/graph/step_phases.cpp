#include "graph/step_phases.hpp"

#include "mpm/audit.hpp"
#include "mpm/boundary.hpp"
#include "mpm/grid_update.hpp"
#include "mpm/node_work.hpp"
#include "mpm/transfer.hpp"
#include "mpm/two_field.hpp"

namespace sandgraph::graph {
namespace {

void place_bodies(GroundState& s) {
    if (s.bodies.empty()) return;
    std::vector<mpm::Enrichment> cuts;
    for (const Body& body : s.bodies) cuts.push_back(mpm::enrichment_of(body.plate));
    mpm::set_bodies(s.grid, cuts, s.points.half);
}

void scatter_points(GroundState& s) {
    place_bodies(s);
    mpm::refresh(s.order, s.points, s.grid);
    std::span<const Stress> stress = s.points.stress;
    if (s.bands.active()) stress = s.bands.stress(s.points, s.order, s.grid);
    if (s.means.active()) {
        s.means.weigh(s.points, s.order, s.grid, s.settings.boundaries);
        stress = s.means.stress(stress, s.order);
    }
    mpm::points_to_grid(s.points, stress, s.order, s.grid);
}

void load_grid(GroundState& s) {
    if (s.settings.surcharge != 0) mpm::add_surcharge(s.settings.surcharge, s.points, s.grid);
    for (Body& body : s.bodies) mpm::add_contact(body.plate, s.points, s.order, s.grid, body.contact);
}

mpm::GridStep grid_step(const GroundState& s) {
    const StepSettings& set = s.settings;
    return {set.dt, set.gravity, set.scheme.damping, set.scheme.mass_scaling, set.boundaries, s.light};
}

void move_grid(GroundState& s) {
    mpm::update_grid(grid_step(s), s.grid);
    for (Body& body : s.bodies) {
        mpm::advance_slip(body.plate, s.grid, s.settings.dt, body.contact);
        mpm::advance(body.plate, s.settings.dt);
    }
}

void gather_points(GroundState& s) {
    s.status =
        mpm::grid_to_points(s.grid, {s.settings.dt, s.settings.scheme.pic_fraction}, s.order, s.points);
    if (s.means.active()) s.means.strain(s.order, s.points);
    s.work_before = mpm::stress_work(s.points);
    if (s.bands.active()) s.stress_work += s.bands.work(s.points);
    if (!s.bodies.empty()) s.node_work += mpm::node_work(grid_step(s), s.grid);
}

void account_work(GroundState& s) { s.stress_work += 0.5 * (s.work_before + mpm::stress_work(s.points)); }

// The stages of the law, each with the batch of all points.
void add_law(GroundState& s, std::vector<Phase>& phases) {
    for (stress::Stage& stage : s.law->stages())
        phases.push_back({std::move(stage.name), std::move(stage.reads), std::move(stage.writes),
                          [&s, run = std::move(stage.run)] { run(s.batch()); }});
}

}  // namespace

std::vector<Phase> step_phases(GroundState& s) {
    std::vector<Phase> phases = {
        {"points to grid",
         {{Data::points, 0}, {Data::stress, 0}, {Data::bodies, 0}, {Data::order, 0}},
         {{Data::order, 1}, {Data::grid, 1}},
         [&s] { scatter_points(s); }},
        {"contact",
         {{Data::grid, 1}, {Data::points, 0}, {Data::order, 1}, {Data::bodies, 0}, {Data::contact, 0}},
         {{Data::grid, 2}, {Data::contact, 1}},
         [&s] { load_grid(s); }},
        {"grid update",
         {{Data::grid, 2}, {Data::contact, 1}, {Data::bodies, 0}},
         {{Data::grid, 3}, {Data::contact, 2}, {Data::bodies, 1}},
         [&s] { move_grid(s); }},
        {"grid to points",
         {{Data::grid, 3}, {Data::points, 0}, {Data::order, 1}, {Data::stress, 0}},
         {{Data::points, 1}, {Data::increments, 1}, {Data::order, 2}, {Data::energy, 1}},
         [&s] { gather_points(s); }}};
    add_law(s, phases);
    phases.push_back({"work",
                      {{Data::stress, settled}, {Data::increments, 1}, {Data::points, 1}, {Data::energy, 1}},
                      {{Data::energy, 2}},
                      [&s] { account_work(s); }});
    return phases;
}

}  // namespace sandgraph::graph

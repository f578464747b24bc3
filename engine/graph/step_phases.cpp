#include "graph/step_phases.hpp"

#include "graph/rve_law.hpp"
#include "graph/screening_law.hpp"
#include "mpm/audit.hpp"
#include "mpm/grid_update.hpp"
#include "mpm/points_to_grid.hpp"
#include "mpm/surcharge.hpp"
#include "mpm/two_field.hpp"

namespace sandgraph::graph {
namespace {

void scatter_points(GroundState& s) {
    if (s.has_plate) mpm::set_divide(s.grid, mpm::divide_of(s.plate), s.points.half);
    mpm::refresh(s.order, s.points, s.grid);
    mpm::points_to_grid(s.points, s.order, s.grid);
}

void load_grid(GroundState& s) {
    if (s.settings.surcharge != 0) mpm::add_surcharge(s.settings.surcharge, s.points, s.grid);
    if (s.has_plate) mpm::add_contact(s.plate, s.points, s.order, s.grid, s.contact);
}

void move_grid(GroundState& s) {
    const StepSettings& set = s.settings;
    mpm::update_grid(
        {set.dt, Vec2(0, -set.gravity), set.scheme.damping, set.scheme.mass_scaling, set.boundaries}, s.grid);
    if (!s.has_plate) return;
    mpm::advance_slip(s.plate, s.grid, set.dt, s.contact);
    mpm::advance(s.plate, set.dt);
}

void gather_points(GroundState& s) {
    s.status =
        mpm::grid_to_points(s.grid, {s.settings.dt, s.settings.scheme.pic_fraction}, s.order, s.points);
    s.work_before = mpm::stress_work(s.points);
}

void account_work(GroundState& s) { s.stress_work += 0.5 * (s.work_before + mpm::stress_work(s.points)); }

Surroundings surroundings(const GroundState& s) {
    return {s.points.x, s.points.y, s.points.volume, s.grid.shape.cell, s.d_over_B};
}

std::vector<Phase> screening_phases(GroundState& s, ScreeningLaw& law) {
    return {{"predict", {"increments"}, {"predicted"}, [&s, &law] { law.predict(s.batch()); }},
            {"route", {"predicted"}, {"due"}, [&s, &law] { law.route(s.batch()); }},
            {"surrogate", {"due"}, {"answers"}, [&s, &law] { law.ask(s.batch()); }},
            {"grains", {"due"}, {"driven"}, [&s, &law] { law.drive(s.batch()); }},
            {"hand-over", {"answers", "driven"}, {"stress"}, [&s, &law] {
                 law.hand_over(s.batch(), surroundings(s));
             }}};
}

std::vector<Phase> stress_phases(GroundState& s) {
    if (auto* law = dynamic_cast<ScreeningLaw*>(s.law.get())) return screening_phases(s, *law);
    if (auto* rve = dynamic_cast<RveLaw*>(s.law.get()))
        return {{"predict", {"increments"}, {"predicted"}, [&s, rve] { rve->predict(s.batch()); }},
                {"route", {"predicted"}, {"due"}, [&s, rve] { rve->route(s.batch()); }},
                {"grains", {"due"}, {"stress"}, [&s, rve] { rve->drive(s.batch()); }}};
    return {{"law", {"increments"}, {"stress"}, [&s] { s.law->update(s.batch()); }}};
}

}  // namespace

std::vector<Phase> step_phases(GroundState& s) {
    std::vector<Phase> phases = {
        {"points to grid", {"points", "last stress"}, {"grid sums"}, [&s] { scatter_points(s); }},
        {"contact", {"grid sums", "points"}, {"grid forces"}, [&s] { load_grid(s); }},
        {"grid update", {"grid forces"}, {"grid motion"}, [&s] { move_grid(s); }},
        {"grid to points", {"grid motion", "last stress"}, {"increments"}, [&s] { gather_points(s); }}};
    for (Phase& phase : stress_phases(s)) phases.push_back(std::move(phase));
    phases.push_back({"work", {"stress", "increments"}, {"energy"}, [&s] { account_work(s); }});
    return phases;
}

}  // namespace sandgraph::graph

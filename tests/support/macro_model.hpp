#pragma once
#include <memory>
#include <numeric>
#include <optional>
#include <vector>

#include "mpm/audit.hpp"
#include "mpm/boundary.hpp"
#include "mpm/contact.hpp"
#include "mpm/grid_update.hpp"
#include "mpm/transfer.hpp"
#include "mpm/two_field.hpp"
#include "stress/law.hpp"

namespace sandgraph::support {

// The macro scale alone, stage after stage, with a closed-form law: what the tests drive.
struct MacroModel {
    explicit MacroModel(const mpm::GridShape& shape) : grid(shape) {}

    mpm::Grid grid;
    mpm::Points points;
    mpm::Order order;
    mpm::GridStep update;
    mpm::Advance advance;
    std::unique_ptr<stress::Law> law;
    std::optional<mpm::RigidPlate> plate;
    mpm::Contact contact;
    double surcharge = 0;
    double work = 0, plate_work = 0;  // accumulated [J/m]
    bool audit = false;
    std::vector<std::int32_t> all;

    void set_time_step(double dt) { update.dt = advance.dt = dt; }

    void start() {
        all.resize(points.size());
        std::iota(all.begin(), all.end(), 0);
        contact = mpm::make_contact(points.size());
        if (law) law->initialise(batch());
    }

    // Everything up to the grid's motion: the unbalanced forces are in the nodes afterwards.
    void load_grid() {
        if (plate) mpm::set_enrichment(grid, mpm::enrichment_of(*plate), points.half);
        mpm::refresh(order, points, grid);
        mpm::points_to_grid(points, order, grid);
        if (surcharge != 0) mpm::add_surcharge(surcharge, points, grid);
        if (plate) mpm::add_contact(*plate, points, order, grid, contact);
    }

    mpm::Status step() {
        load_grid();
        mpm::update_grid(update, grid);
        if (plate) move_plate();
        const mpm::Status status = mpm::grid_to_points(grid, advance, order, points);
        update_stress();
        return status;
    }

    void steps(int count) {
        for (int k = 0; k < count; ++k) step();
    }

  private:
    stress::Batch batch() { return {all, points.F_inc, points.stress, advance.dt}; }

    void move_plate() {
        mpm::advance_slip(*plate, grid, update.dt, contact);
        if (audit) plate_work += mpm::plate_work(*plate, contact.reaction, update.dt);
        mpm::advance(*plate, update.dt);
    }

    void update_stress() {
        if (!law) return;
        if (audit) work += 0.5 * mpm::stress_work(points);
        law->update(batch());
        if (audit) work += 0.5 * mpm::stress_work(points);
    }
};

}  // namespace sandgraph::support

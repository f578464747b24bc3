#pragma once
#include <limits>
#include <optional>
#include <vector>

#include "base/archive.hpp"
#include "io/frame.hpp"
#include "simulation/load_bar.hpp"
#include "simulation/simulation.hpp"

namespace sandgraph::simulation {

// The load series: each row holds the mean loads since the row before, for the whole plate, and the mean d/B
// that they belong to. Without an anchor rows fall due by time and hold no loads.
class LoadRecorder {
  public:
    // `every`: between rows, in marks (Simulation::mark); `factor`: 2 for a half model; `unit_load`: B (gamma
    // H + q) [N/m].
    LoadRecorder(double every, double factor, double unit_load)
        : every_(every), factor_(factor), unit_load_(unit_load) {}
    // After each step; a row when one is due.
    std::optional<io::LoadRow> after_step(const Simulation& simulation);
    bool due_by(double mark) const { return mark >= next_; }
    // Largest kinetic energy over the plate's work, from d/B = 0.005 on: how far from quasi-static. Where the
    // plate has worked less than it takes to lift what lies on it, that work counts. NaN before, and where
    // the ground has worked on the plate.
    double kinetic_share_max() const { return kinetic_share_max_; }
    double last() const { return last_; }  // load of the last row [N/m]
    void archive(Archive& a);

  private:
    void add(const Simulation& simulation);
    double work_scale(const Simulation& simulation) const;  // of the plate so far [J/m], above zero
    void add_error(const Simulation& simulation, io::LoadRow& row);
    void add_drag(const Simulation& simulation, io::LoadRow& row);
    io::LoadRow row(const Simulation& simulation, double load) const;
    double every_, factor_, unit_load_;
    double next_ = 0, steps_ = 0, d_ = 0, load_ = 0, leading_ = 0, trailing_ = 0, plate_work_ = 0, last_ = 0;
    struct Account {  // since the start, of the whole plate [J/m], and its travel [m]
        double damping = 0, gained = 0, kinetic = 0, plate = 0, travel = 0;
    } before_;  // at the last row
    LoadBar bar_;
    double kinetic_share_max_ = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace sandgraph::simulation

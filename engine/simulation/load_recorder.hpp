#pragma once
#include <limits>
#include <optional>
#include <vector>

#include "base/archive.hpp"
#include "io/frame.hpp"
#include "simulation/simulation.hpp"

namespace sandgraph::simulation {

// The load series: each row holds the mean loads since the row before, for the whole plate, and the mean d/B
// that they belong to. Without an anchor rows fall due by time and hold no loads.
class LoadRecorder {
  public:
    // `every`: between rows, in marks (Simulation::mark); `factor`: 2 for a half model.
    LoadRecorder(double every, double factor) : every_(every), factor_(factor) {}
    // After each step; a row when one is due.
    std::optional<io::LoadRow> after_step(const Simulation& simulation);
    // Largest kinetic energy over the plate's work, from d/B = 0.005 on: how far from quasi-static. NaN
    // before.
    double kinetic_share_max() const { return kinetic_share_max_; }
    double last() const { return last_; }  // load of the last row [N/m]
    void archive(Archive& a);

  private:
    void add(const Simulation& simulation);
    io::LoadRow row(const Simulation& simulation, double load) const;
    double every_, factor_;
    double next_ = 0, steps_ = 0, d_ = 0, load_ = 0, leading_ = 0, trailing_ = 0, plate_work_ = 0, last_ = 0;
    double kinetic_share_max_ = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace sandgraph::simulation

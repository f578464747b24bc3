#pragma once
#include <vector>

#include "io/frame.hpp"

namespace sandgraph::simulation {

// What the estimate of a load's error is itself worth, as shares of the largest load so far: measured
// (docs/accuracy.md, "The load's own error bar").
struct LoadBarSettings {
    double miss = 0.015;  // half of a 95 % interval, up to the peak: what is left when every point audits
    double scatter =
        0.05;              // the same, added past the peak: what a run is parted by from its equals there ...
    double widens = 0.02;  // ... once it has gone on by so much d/B
};

// The 95 % interval of a screening run's load, row by row: docs/how_it_works.md (eq. 41f).
class LoadBar {
  public:
    explicit LoadBar(LoadBarSettings settings = {}) : settings_(settings) {}
    // Fills corrected, low and high of the row, whose load lacks `correction` with the standard error
    // `sampling` [N/m].
    void add_to(io::LoadRow& row, double correction, double sampling);

    std::vector<double> state() const { return {peak_, peak_d_}; }
    void set_state(double peak, double peak_d) { peak_ = peak, peak_d_ = peak_d; }

  private:
    double past_peak(double d_over_B) const;  // 0 up to the largest load, 1 where the bar is at its widest

    LoadBarSettings settings_;
    double peak_ = 0, peak_d_ = 0;  // largest load so far [N/m], and where
};

}  // namespace sandgraph::simulation

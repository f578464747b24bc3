#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "base/console.hpp"

namespace sandgraph::simulation {

// Where a run stands.
struct ProgressState {
    std::int64_t step = 0;
    double d_over_B = 0, target = 0;  // now and at the end
    double load = 0;                  // of the whole plate [N/m]
    std::int64_t rve_active = 0;      // points that own a packing
};

// "step 1200  d/B 0.0150 of 0.4  load 12.3 kN/m  RVEs 812  4 min 10 s left"; `left` [s], if it is known.
std::string progress_line(const ProgressState& state, std::optional<double> left);

// Time left from the recent speed of d/B: the pull slows down as more packings strain.
class TimeLeft {
  public:
    // `now` [s], any origin. Empty until the plate has moved.
    std::optional<double> update(const ProgressState& state, double now);

  private:
    static constexpr double memory = 20;                    // [s] over which older speeds are forgotten
    double last_time_ = 0, last_d_over_B_ = 0, speed_ = 0;  // speed_ [d/B per s]
    bool started_ = false;
};

// The progress of a run, live on a terminal.
class Progress {
  public:
    explicit Progress(std::FILE* out = stderr) : line_(out) {}
    void update(const ProgressState& state, double now = wall_clock());  // now [s], any origin
    void finish() { line_.finish(); }

  private:
    LiveLine line_;
    TimeLeft time_left_;
};

}  // namespace sandgraph::simulation

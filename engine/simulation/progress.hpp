#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "base/console.hpp"

namespace sandgraph::simulation {

// Where a run stands.
struct ProgressState {
    std::int64_t step = 0;
    double mark = 0, target = 0;  // now and at the end: d/B, without an anchor time [s]
    double load = 0;              // of the whole plate [N/m]
    std::int64_t rve_active = 0;  // points that own a packing
    bool anchored = true;
};

// "40 s", "4 min 10 s", "3 h 5 min".
std::string duration_text(double seconds);

// "step 1200  d/B 0.0150 of 0.4  load 12.3 kN/m  RVEs 812  4 min 10 s left"; `left` [s], if it is known.
// Without an anchor "step 1200  0.0150 of 1 s  RVEs 812".
std::string progress_line(const ProgressState& state, std::optional<double> left);

// Time left from the recent speed of the mark: the run slows down as more packings strain.
class TimeLeft {
  public:
    // `now` [s], any origin. Empty until the mark has moved.
    std::optional<double> update(const ProgressState& state, double now);

  private:
    static constexpr double memory = 20;                // [s] over which older speeds are forgotten
    double last_time_ = 0, last_mark_ = 0, speed_ = 0;  // speed_ [marks per s]
    bool started_ = false;
};

// The progress of a run, live on a terminal.
class Progress {
  public:
    explicit Progress(std::FILE* out = stderr) : line_(out) {}
    bool due(double now = wall_clock()) const { return line_.due(now); }  // is it time to show again?
    void update(const ProgressState& state, double now = wall_clock());   // now [s], any origin
    void finish() { line_.finish(); }

  private:
    LiveLine line_;
    TimeLeft time_left_;
};

}  // namespace sandgraph::simulation

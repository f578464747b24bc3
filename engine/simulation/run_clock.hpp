#pragma once
#include <ctime>

#include "base/archive.hpp"
#include "base/console.hpp"

namespace sandgraph::simulation {

// What a run has cost, with the runs that it resumed. Counts from start() on.
class RunClock {
  public:
    void start() { wall_start_ = wall_clock(), cpu_start_ = cpu_clock(), running_ = true; }
    double wall() const { return wall_before_ + (running_ ? wall_clock() - wall_start_ : 0); }  // [s]
    double cpu() const { return cpu_before_ + (running_ ? cpu_clock() - cpu_start_ : 0); }      // [s]

    void archive(Archive& a) {
        std::vector<double> clocks = {wall(), cpu()};
        field_of_known_length(a, "session", clocks);
        if (a.reading()) wall_before_ = clocks[0], cpu_before_ = clocks[1];
    }

  private:
    static double cpu_clock() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }
    double wall_before_ = 0, cpu_before_ = 0, wall_start_ = 0, cpu_start_ = 0;
    bool running_ = false;
};

}  // namespace sandgraph::simulation

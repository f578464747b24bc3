#pragma once
#include <string_view>

#include "app/live_line.hpp"
#include "base/interrupt.hpp"

namespace sandgraph::app {

// Progress of a preparation: "consolidating 40 %". Asked to stop (Ctrl-C), the next update throws
// Interrupted.
class StageProgress {
  public:
    StageProgress() { catch_interrupts(); }
    void update(std::string_view stage, double fraction);

  private:
    LiveLine line_;
    double start_ = wall_clock();
};

}  // namespace sandgraph::app

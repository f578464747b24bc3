#pragma once
#include <string_view>

#include "app/live_line.hpp"

namespace sandgraph::app {

// Progress of a preparation: "consolidating 40 %".
class StageProgress {
  public:
    void update(std::string_view stage, double fraction);

  private:
    LiveLine line_;
    double start_ = wall_clock();
};

}  // namespace sandgraph::app

#include "app/stage_progress.hpp"

#include <fmt/format.h>

namespace sandgraph::app {

void StageProgress::update(std::string_view stage, double fraction) {
    stop_if_interrupted();
    const double now = wall_clock();
    if (line_.due(now))
        line_.show(fmt::format("{:.0f} s  {} {:.0f} %", now - start_, stage, 100 * fraction), now);
}

}  // namespace sandgraph::app

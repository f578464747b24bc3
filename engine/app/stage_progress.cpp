#include "app/stage_progress.hpp"

#include <fmt/format.h>

namespace sandgraph::app {

namespace {

constexpr double patience = 1;  // [s]; what is done sooner needs no progress

}  // namespace

void StageProgress::update(std::string_view stage, double fraction) {
    const double now = wall_clock();
    if (line_.due(now))
        line_.show(fmt::format("{:.0f} s  {} {:.0f} %", now - start_, stage, 100 * fraction), now);
}

}  // namespace sandgraph::app

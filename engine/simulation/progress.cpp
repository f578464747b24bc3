#include "simulation/progress.hpp"

#include <fmt/format.h>

#include <cmath>

namespace sandgraph::simulation {
std::string duration_text(double seconds) {
    if (!(seconds < 1e9)) return "more than 30 years";
    const auto s = static_cast<std::int64_t>(std::lround(seconds));
    if (s < 60) return fmt::format("{} s", s);
    if (s < 3600) return fmt::format("{} min {} s", s / 60, s % 60);
    return fmt::format("{} h {} min", s / 3600, s % 3600 / 60);
}

std::string progress_line(const ProgressState& state, std::optional<double> left) {
    std::string line = fmt::format("step {}  ", state.step);
    line += state.anchored ? fmt::format("d/B {:.4f} of {:g}  load {:.3g} kN/m", state.mark, state.target,
                                         state.load / 1000)
                           : fmt::format("{:.4f} of {:g} s", state.mark, state.target);
    line += fmt::format("  RVEs {}", state.rve_active);
    if (left) line += fmt::format("  {} left", duration_text(*left));
    return line;
}

std::optional<double> TimeLeft::update(const ProgressState& state, double now) {
    const double elapsed = now - last_time_, moved = state.mark - last_mark_;
    if (started_ && elapsed > 0) {
        const double keep = speed_ > 0 ? std::exp(-elapsed / memory) : 0;
        speed_ = keep * speed_ + (1 - keep) * moved / elapsed;
    }
    started_ = true;
    last_time_ = now;
    last_mark_ = state.mark;
    if (speed_ <= 0) return std::nullopt;
    return (state.target - state.mark) / speed_;
}

void Progress::update(const ProgressState& state, double now) {
    if (line_.due(now)) line_.show(progress_line(state, time_left_.update(state, now)), now);
}

}  // namespace sandgraph::simulation

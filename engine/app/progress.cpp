#include "app/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cmath>

namespace sandgraph::app {
namespace {

constexpr double terminal_interval = 0.2, plain_interval = 10;  // [s]

std::string duration(double seconds) {
    const auto s = static_cast<std::int64_t>(std::lround(seconds));
    if (s < 60) return fmt::format("{} s", s);
    if (s < 3600) return fmt::format("{} min {} s", s / 60, s % 60);
    return fmt::format("{} h {} min", s / 3600, s % 3600 / 60);
}

}  // namespace

std::string progress_line(const ProgressState& state, std::optional<double> left) {
    std::string line = fmt::format("step {}  d/B {:.4f} of {:g}  load {:.3g} kN/m  RVEs {}", state.step,
                                   state.d_over_B, state.target, state.load / 1000, state.rve_active);
    if (left) line += fmt::format("  {} left", duration(*left));
    return line;
}

std::optional<double> TimeLeft::update(const ProgressState& state, double now) {
    const double elapsed = now - last_time_, moved = state.d_over_B - last_d_over_B_;
    if (started_ && elapsed > 0) {
        const double keep = speed_ > 0 ? std::exp(-elapsed / memory) : 0;
        speed_ = keep * speed_ + (1 - keep) * moved / elapsed;
    }
    started_ = true;
    last_time_ = now;
    last_d_over_B_ = state.d_over_B;
    if (speed_ <= 0) return std::nullopt;
    return (state.target - state.d_over_B) / speed_;
}

Progress::Progress(std::FILE* out) : out_(out), terminal_(isatty(fileno(out)) != 0) {}

void Progress::update(const ProgressState& state) {
    const std::chrono::duration<double> now = std::chrono::steady_clock::now().time_since_epoch();
    update(state, now.count());
}

void Progress::update(const ProgressState& state, double now) {
    if (shown_ && now < next_) return;
    shown_ = true;
    next_ = now + (terminal_ ? terminal_interval : plain_interval);
    const std::string line = progress_line(state, time_left_.update(state, now));
    fmt::print(out_, "{}{}{}", terminal_ ? "\r" : "", line, terminal_ ? "\033[K" : "\n");
    std::fflush(out_);
    live_ = terminal_;
}

void Progress::finish() {
    if (live_) fmt::print(out_, "\n");
    live_ = false;
}

}  // namespace sandgraph::app

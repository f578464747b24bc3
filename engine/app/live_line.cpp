#include "app/live_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>

namespace sandgraph::app {
namespace {

constexpr double terminal_interval = 0.2, plain_interval = 10;  // [s]

}  // namespace

LiveLine::LiveLine(std::FILE* out) : out_(out), terminal_(isatty(fileno(out)) != 0) {}

void LiveLine::show(const std::string& text, double now) {
    next_ = now + (terminal_ ? terminal_interval : plain_interval);
    fmt::print(out_, "{}{}{}", terminal_ ? "\r" : "", text, terminal_ ? "\033[K" : "\n");
    std::fflush(out_);
    live_ = terminal_;
}

void LiveLine::finish() {
    if (live_) fmt::print(out_, "\n");
    live_ = false;
}

double wall_clock() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace sandgraph::app

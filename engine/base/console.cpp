#include "base/console.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>

#include "base/contracts.hpp"

namespace sandgraph {
namespace {

constexpr double terminal_interval = 0.2, plain_interval = 10;  // [s]

// A terminal that has gone or a log on a full disk must not end a run: what cannot be written is left out.
void write_softly(std::FILE* out, std::string_view text) {
    std::fwrite(text.data(), 1, text.size(), out);
    std::fflush(out);
    std::clearerr(out);
}

}  // namespace

void tell(std::string_view text) { write_softly(stdout, text); }

void notice(std::string_view line) { write_softly(stderr, fmt::format("{}\n", line)); }

void broken_contract(const char* kind, const char* condition, const char* file, int line) {
    notice(fmt::format("{}:{}: {} broken: {}", file, line, kind, condition));
    std::abort();
}

double wall_clock() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

LiveLine::LiveLine(std::FILE* out) : out_(out), terminal_(isatty(fileno(out)) != 0) {}

void LiveLine::show(const std::string& text, double now) {
    next_ = now + (terminal_ ? terminal_interval : plain_interval);
    write_softly(out_, fmt::format("{}{}{}", terminal_ ? "\r" : "", text, terminal_ ? "\033[K" : "\n"));
    live_ = terminal_;
}

void LiveLine::finish() {
    if (live_) write_softly(out_, "\n");
    live_ = false;
}

void StageProgress::update(std::string_view stage, double fraction) {
    stop_if_interrupted();
    const double now = wall_clock();
    if (line_.due(now))
        line_.show(fmt::format("{:.0f} s  {} {:.0f} %", now - start_, stage, 100 * fraction), now);
}

void Tally::done(std::string_view stage) {
    const std::lock_guard lock(telling_);
    SG_EXPECT(done_ < all_);
    ++done_;
    if (progress_) progress_(stage, static_cast<double>(done_) / static_cast<double>(all_));
}

}  // namespace sandgraph

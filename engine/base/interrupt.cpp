#include "base/interrupt.hpp"

#include <atomic>
#include <csignal>

namespace sandgraph {
namespace {

std::atomic<bool> asked{false};
static_assert(std::atomic<bool>::is_always_lock_free);

void on_signal(int signal) {
    if (asked.exchange(true)) {
        std::signal(signal, SIG_DFL);
        std::raise(signal);
    }
}

}  // namespace

void catch_interrupts() {
    std::signal(SIGINT, on_signal);
    std::signal(SIGTERM, on_signal);
}

bool interrupted() { return asked.load(); }

void stop_if_interrupted() {
    if (interrupted()) throw Interrupted();
}

}  // namespace sandgraph

#include "training/stop.hpp"

#include <csignal>

namespace sandgraph::training {
namespace {

volatile std::sig_atomic_t asked = 0;

void on_signal(int signal) {
    asked = 1;
    std::signal(signal, SIG_DFL);
}

}  // namespace

void catch_stops() {
    std::signal(SIGINT, on_signal);
    std::signal(SIGTERM, on_signal);
}

bool stop_asked() { return asked != 0; }

}  // namespace sandgraph::training

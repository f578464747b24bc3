#pragma once
#include <exception>

namespace sandgraph {

// SIGINT and SIGTERM ask long work to stop at its next clean point (a step, an epoch); a second one ends the
// program at once.
void catch_interrupts();
bool interrupted();

// Leaves work that cannot go on from its middle (the making of a packing): its results are thrown away.
struct Interrupted : std::exception {
    const char* what() const noexcept override { return "stopped; nothing was written"; }
};
void stop_if_interrupted();

}  // namespace sandgraph

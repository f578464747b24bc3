#pragma once

namespace sandgraph {

// SIGINT and SIGTERM ask long work to stop at its next clean point (a step, an epoch); a second one ends the
// program at once.
void catch_interrupts();
bool interrupted();

}  // namespace sandgraph

#pragma once

namespace sandgraph::app {

// SIGINT and SIGTERM ask a run to stop at the next step; a second one ends the program at once.
void catch_interrupts();
bool interrupted();

}  // namespace sandgraph::app

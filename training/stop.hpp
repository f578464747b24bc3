#pragma once

namespace sandgraph::training {

// SIGINT and SIGTERM ask a training to stop after the epoch at hand; a second one ends the program at once.
void catch_stops();
bool stop_asked();

}  // namespace sandgraph::training

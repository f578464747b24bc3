#pragma once
#include <memory>

namespace sandgraph::simulation {
class Crew;
}

namespace sandgraph::app {

// Exit codes that scripts rely on.
enum ExitCode { exit_done = 0, exit_failed = 1, exit_bad_input = 2, exit_stopped_early = 3 };

// Parses the arguments, runs the command, tells errors in one line on stderr. Returns the exit code. `crew`:
// processes that help with a run, if there are any.
int run_command_line(int argc, const char* const* argv, std::shared_ptr<simulation::Crew> crew = {});

}  // namespace sandgraph::app

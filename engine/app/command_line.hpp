#pragma once

namespace sandgraph::app {

// Exit codes that scripts rely on.
enum ExitCode { exit_done = 0, exit_failed = 1, exit_bad_input = 2, exit_stopped_early = 3 };

// Parses the arguments, runs the command, tells errors in one line on stderr. Returns the exit code.
int run_command_line(int argc, const char* const* argv);

}  // namespace sandgraph::app

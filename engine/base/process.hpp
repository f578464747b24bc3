#pragma once
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

namespace sandgraph {

inline constexpr int program_missing = 127;

// Runs a program (searched in PATH, no shell) in `folder`, stdin empty, stdout and stderr to `messages`;
// returns its exit status, 128 + signal if it was killed, program_missing if there is none of that name.
int run_program(std::vector<std::string> arguments, const std::filesystem::path& folder,
                const std::filesystem::path& messages);

// Goes on as another program, arguments[0] being its path, with the terminal and the process of this one.
// Throws std::system_error when it cannot be started.
[[noreturn]] void become_program(std::vector<std::string> arguments);

// SIGINT, SIGTERM and SIGHUP ask long work to stop at its next clean point (a step, an epoch); a second one
// (SIGHUP apart) ends the program at once.
void catch_interrupts();
bool interrupted();

// What this process may use [B]: the machine's memory, less where its control group or its own limit says so.
double memory_limit();

// Leaves work that cannot go on from its middle (the making of a packing): its results are thrown away.
struct Interrupted : std::exception {
    const char* what() const noexcept override { return "stopped; nothing was written"; }
};
void stop_if_interrupted();

}  // namespace sandgraph

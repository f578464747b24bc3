#pragma once
#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

// Child processes as the kernel has them; what the program uses is process.hpp and child_program.hpp.
namespace sandgraph {

inline constexpr int no_such_program = 127;  // status of a child whose program is not there, as of a shell

// alone: in a process group of its own, and asked to stop (SIGINT) when the thread that started it dies.
enum class Company : std::uint8_t { with_us, alone };

// For exec; good as long as `arguments`.
std::vector<char*> argv_of(std::vector<std::string>& arguments);

// Starts a program (searched in PATH, no shell) in `folder`, stdin empty, stdout and stderr to `messages`.
pid_t spawn(std::vector<std::string> arguments, const std::filesystem::path& folder,
            const std::filesystem::path& messages, Company company);

// Exit status of a child that has ended, 128 + signal if it was killed; none while it runs, where `wait` is
// false.
std::optional<int> status_of(pid_t child, bool wait);

}  // namespace sandgraph

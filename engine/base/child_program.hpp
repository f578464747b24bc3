#pragma once
#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sandgraph {

// A program that runs beside this one, started as run_program (process.hpp) does. It is in a process group of
// its own: a Ctrl-C at the terminal reaches it by `ask_to_stop` alone, once. When the thread that started it
// dies, it is asked to stop, too.
class ChildProgram {
  public:
    ChildProgram(std::vector<std::string> arguments, const std::filesystem::path& folder,
                 const std::filesystem::path& messages);
    ~ChildProgram();  // asks it to stop and waits for its end
    ChildProgram(const ChildProgram&) = delete;
    ChildProgram& operator=(const ChildProgram&) = delete;

    std::optional<int> ended();  // its exit status as run_program returns it; none while it runs
    void ask_to_stop() const;    // SIGINT
    pid_t id() const { return pid_; }

  private:
    pid_t pid_;
    std::optional<int> status_;
};

// For `arguments`: the program that runs now, also when its file has been replaced since it was started.
inline constexpr const char* same_program = "/proc/self/exe";

// The file of this very program.
std::filesystem::path this_program();

}  // namespace sandgraph

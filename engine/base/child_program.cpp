#include "base/child_program.hpp"

#include <csignal>
#include <system_error>

#include "base/spawn.hpp"

namespace sandgraph {

ChildProgram::ChildProgram(std::vector<std::string> arguments, const std::filesystem::path& folder,
                           const std::filesystem::path& messages)
    : pid_(spawn(std::move(arguments), folder, messages, Company::alone)) {}

ChildProgram::~ChildProgram() {
    ask_to_stop();
    try {
        if (!status_) status_of(pid_, true);
    } catch (const std::system_error&) {  // there is nobody to wait for
    }
}

std::optional<int> ChildProgram::ended() {
    if (!status_) status_ = status_of(pid_, false);
    return status_;
}

void ChildProgram::ask_to_stop() const {
    if (!status_) ::kill(pid_, SIGINT);
}

std::filesystem::path this_program() { return std::filesystem::read_symlink("/proc/self/exe"); }

}  // namespace sandgraph

#include "app/resume_command.hpp"

#include <fmt/format.h>

namespace sandgraph::app {
namespace {

// A word as a shell takes it.
std::string quoted(const std::string& word) {
    const bool plain = word.find_first_of(" \"'$&|;<>()[]*?#~\\`!{}") == std::string::npos && !word.empty();
    if (plain) return word;
    std::string out = "'";
    for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return out + "'";
}

}  // namespace

std::string resume_command(const RunRequest& a, const std::filesystem::path& folder) {
    std::string out = fmt::format("sandgraph run {} -o {}", quoted(a.scene), quoted(folder.string()));
    if (!a.mode.empty()) out += " --mode " + a.mode;
    for (const std::string& assignment : a.set) out += " --set " + quoted(assignment);
    if (a.threads > 0) out += fmt::format(" --threads {}", a.threads);
    if (a.until > 0) out += fmt::format(" --until {}", a.until);
    return out + " --resume";
}

}  // namespace sandgraph::app

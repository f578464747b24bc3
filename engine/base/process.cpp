#include "base/process.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <fstream>
#include <limits>
#include <system_error>

#include "base/contracts.hpp"
#include "base/spawn.hpp"

namespace sandgraph {
namespace {

static_assert(program_missing == no_such_program);
constexpr double kUnlimited = std::numeric_limits<double>::infinity();

// "4:memory:/path" (version 1) or "0::/path" (version 2) of /proc/self/cgroup.
double limit_of(const std::string& line) {
    const std::size_t colon = line.find(':'), second = line.find(':', colon + 1);
    if (second == std::string::npos) return kUnlimited;
    const std::string controllers = line.substr(colon + 1, second - colon - 1),
                      path = line.substr(second + 1);
    const bool first_version = controllers == "memory";
    if (!first_version && !controllers.empty()) return kUnlimited;
    const std::filesystem::path root(first_version ? "/sys/fs/cgroup/memory" : "/sys/fs/cgroup");
    const char* name = first_version ? "memory.limit_in_bytes" : "memory.max";
    double limit = kUnlimited, value = 0;
    // Seen from inside a container the path may not exist; the root is then the container's own.
    for (const auto& file : {root / path.substr(1) / name, root / name})
        if (std::ifstream in(file); in >> value) limit = std::min(limit, value);
    return limit;
}

double control_group_limit() {
    double limit = kUnlimited;
    std::ifstream groups("/proc/self/cgroup");
    for (std::string line; std::getline(groups, line);) limit = std::min(limit, limit_of(line));
    return limit;
}

std::atomic<bool> asked{false};
static_assert(std::atomic<bool>::is_always_lock_free);

// A closing terminal sends SIGHUP more than once (the shell, then the kernel): that is one wish to stop.
void on_signal(int signal) {
    if (asked.exchange(true) && signal != SIGHUP) {
        std::signal(signal, SIG_DFL);
        std::raise(signal);
    }
}

}  // namespace

int run_program(std::vector<std::string> arguments, const std::filesystem::path& folder,
                const std::filesystem::path& messages) {
    return *status_of(spawn(std::move(arguments), folder, messages, Company::with_us), true);
}

void become_program(std::vector<std::string> arguments) {
    SG_EXPECT(!arguments.empty());
    ::execv(arguments.front().c_str(), argv_of(arguments).data());
    throw std::system_error(errno, std::generic_category(), arguments.front());
}

void catch_interrupts() {
    std::signal(SIGINT, on_signal);
    std::signal(SIGTERM, on_signal);
    if (std::signal(SIGHUP, on_signal) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);  // under nohup
    std::signal(SIGPIPE, SIG_IGN);  // a reader of our output that has gone is no reason to stop
}

double memory_limit() {
    double limit = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
    rlimit own{};
    if (getrlimit(RLIMIT_AS, &own) == 0 && own.rlim_cur != RLIM_INFINITY)
        limit = std::min(limit, static_cast<double>(own.rlim_cur));
    return std::min(limit, control_group_limit());
}

bool interrupted() { return asked.load(); }

void stop_if_interrupted() {
    if (interrupted()) throw Interrupted();
}

}  // namespace sandgraph

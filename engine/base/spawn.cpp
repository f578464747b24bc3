#include "base/spawn.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <system_error>

#include "base/contracts.hpp"

namespace sandgraph {
namespace {

// Whom a shell started in its background ignores SIGINT, and so would its children.
void stand_alone() {
    ::setpgid(0, 0);
    ::signal(SIGINT, SIG_DFL);
    ::prctl(PR_SET_PDEATHSIG, SIGINT);
}

// SIGINT waits while this lives: a child that is asked to stop before it has become a program shall hear it
// as that program, not lose it to the handler that it has from us.
class Held {
  public:
    Held() {
        sigset_t stop;
        sigemptyset(&stop), sigaddset(&stop, SIGINT);
        ::pthread_sigmask(SIG_BLOCK, &stop, &before_);
    }
    ~Held() { release(); }
    Held(const Held&) = delete;
    Held& operator=(const Held&) = delete;
    void release() const { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

  private:
    sigset_t before_{};
};

// Only async-signal-safe calls: the parent may have threads.
[[noreturn]] void become(char* const* argv, const char* folder, const char* messages, Company company,
                         const Held& held) {
    if (company == Company::alone) stand_alone();
    held.release();
    const int in = ::open("/dev/null", O_RDONLY), out = ::open(messages, O_WRONLY | O_CREAT | O_TRUNC, 0644);
    if (in < 0 || out < 0 || ::chdir(folder) != 0) ::_exit(126);
    ::dup2(in, 0), ::dup2(out, 1), ::dup2(out, 2);
    ::execvp(argv[0], argv);
    ::_exit(errno == ENOENT ? no_such_program : 126);
}

}  // namespace

std::vector<char*> argv_of(std::vector<std::string>& arguments) {
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    return argv;
}

pid_t spawn(std::vector<std::string> arguments, const std::filesystem::path& folder,
            const std::filesystem::path& messages, Company company) {
    SG_EXPECT(!arguments.empty());
    const std::vector<char*> argv = argv_of(arguments);
    const Held held;
    const pid_t child = ::fork();
    if (child < 0)
        throw std::system_error(errno, std::generic_category(), "cannot start " + arguments.front());
    if (child == 0) become(argv.data(), folder.c_str(), messages.c_str(), company, held);
    return child;
}

std::optional<int> status_of(pid_t child, bool wait) {
    int status = 0;
    pid_t found = 0;
    while ((found = ::waitpid(child, &status, wait ? 0 : WNOHANG)) < 0)
        if (errno != EINTR)
            throw std::system_error(errno, std::generic_category(), "cannot wait for a program");
    if (found == 0) return std::nullopt;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace sandgraph

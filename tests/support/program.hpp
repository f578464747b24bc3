#pragma once
#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

// The sandgraph program as a child process: started, signalled, waited for.
namespace sandgraph::support {

struct ProgramLimits {
    rlim_t file_size = RLIM_INFINITY;  // past it a write fails, as on a full disk [B]
};

// Starts `words` with standard output and error into `log`.
inline pid_t start_program(std::vector<std::string> words, const std::filesystem::path& log,
                           const ProgramLimits& limits = {}) {
    std::vector<char*> argv;
    for (std::string& w : words) argv.push_back(w.data());
    argv.push_back(nullptr);
    const pid_t pid = fork();
    if (pid != 0) return pid;
    const int out = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    if (out < 0 || dup2(out, 1) < 0 || dup2(out, 2) < 0) _exit(126);
    if (limits.file_size != RLIM_INFINITY) {
        const rlimit limit{limits.file_size, limits.file_size};
        setrlimit(RLIMIT_FSIZE, &limit);
        signal(SIGXFSZ, SIG_IGN);  // the write itself fails, with EFBIG
    }
    execv(argv[0], argv.data());
    _exit(127);
}

// Its exit code, or 128 + the signal that ended it.
inline int finish_program(pid_t pid) {
    int status = 0;
    waitpid(pid, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

inline bool program_runs(pid_t pid) {
    siginfo_t info{};
    return waitid(P_PID, static_cast<id_t>(pid), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == 0;
}

}  // namespace sandgraph::support

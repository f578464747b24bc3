#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "stability/suite.hpp"
#include "support/program.hpp"

namespace sandgraph::stability {

enum class RunMode { full, screening };

// A scratch folder with one small scene, in which the program runs as a user starts it.
class RunFolder {
  public:
    RunFolder(Effort effort, RunMode mode);
    ~RunFolder();
    RunFolder(const RunFolder&) = delete;
    RunFolder& operator=(const RunFolder&) = delete;

    std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }
    // Starts `run scene -o NAME ...`; what it prints goes to NAME.log.
    pid_t start(const std::string& name, const std::vector<std::string>& more = {},
                const support::ProgramLimits& limits = {}) const;
    int run(const std::string& name, const std::vector<std::string>& more = {},
            const support::ProgramLimits& limits = {}) const;
    // As run, and seconds it took.
    double seconds(const std::string& name) const;
    // Waits until run NAME has a checkpoint, and a previous one if asked, or has ended.
    void await_checkpoint(pid_t pid, const std::string& name, bool and_previous = false) const;
    std::string log(const std::string& name) const;  // what the last run NAME printed
    bool can_resume(const std::string& name) const;
    // Leaves the folder behind, to be looked at, and returns it.
    std::string keep() { return kept_ = true, folder_.string(); }

  private:
    std::filesystem::path folder_;
    std::vector<std::string> always_;
    bool kept_ = false;
};

}  // namespace sandgraph::stability

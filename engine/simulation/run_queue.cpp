#include "simulation/run_queue.hpp"

#include <fmt/format.h>

#include <chrono>
#include <fstream>
#include <list>
#include <optional>
#include <thread>

#include "base/child_program.hpp"
#include "base/console.hpp"
#include "base/text.hpp"
#include "io/atomic_file.hpp"
#include "simulation/progress.hpp"

namespace sandgraph::simulation {
namespace {

namespace fs = std::filesystem;

constexpr auto kLookEvery = std::chrono::milliseconds(50);
constexpr int kExitStopped = 3;  // of `sandgraph run`: it can go on

std::vector<std::string> command_of(const SweepRun& run, int threads) {
    std::vector<std::string> words{same_program,       "run",       run.request.scene,       "-o",
                                   run.request.folder, "--threads", std::to_string(threads), "--resume"};
    for (const std::string& assignment : run.request.set) words.insert(words.end(), {"--set", assignment});
    return words;
}

std::string last_line(const fs::path& log) {
    std::ifstream in(log);
    std::string last;
    for (std::string line; std::getline(in, line);)
        if (!trimmed(line).empty()) last = std::string(trimmed(line));
    return last;
}

// One that a signal ended has told nothing.
std::string why_failed(const SweepRun& run, int status) {
    if (status > 128) return fmt::format("ended by signal {}", status - 128);
    const std::string told = last_line(run.log());
    return told.empty() ? fmt::format("ended with code {}", status) : told;
}

struct Job {
    Job(const SweepRun& of, int threads)
        : run(of), child(command_of(of, threads), fs::current_path(), fs::absolute(of.log())) {}
    const SweepRun& run;
    ChildProgram child;
    double start = wall_clock();
};

class Queue {
  public:
    Queue(const SweepPlan& plan, const std::vector<const SweepRun*>& runs, const QueueOptions& options)
        : plan_(plan), runs_(runs), options_(options) {
        for (const SweepRun* run : runs) work_ += run->estimate.seconds;
    }

    QueueEnd run() {
        while (!jobs_.empty() || (next_ < runs_.size() && !interrupted())) {
            if (interrupted() && !end_.interrupted) ask_to_stop();
            while (can_start()) start(*runs_[next_++]);
            jobs_.remove_if([this](Job& job) { return has_ended(job); });
            tell_progress();
            if (!jobs_.empty()) std::this_thread::sleep_for(kLookEvery);
        }
        line_.finish();
        end_.interrupted = interrupted();
        end_.stopped += runs_.size() - next_;
        return end_;
    }

  private:
    bool can_start() const {
        return next_ < runs_.size() && jobs_.size() < static_cast<std::size_t>(options_.jobs) &&
               !interrupted();
    }
    void start(const SweepRun& run) {
        fs::create_directories(run.folder().parent_path());
        fs::remove(run.failure());
        jobs_.emplace_back(run, options_.threads);
    }
    void ask_to_stop() {
        end_.interrupted = true;
        for (const Job& job : jobs_) job.child.ask_to_stop();
    }
    bool has_ended(Job& job) {
        const std::optional<int> status = job.child.ended();
        if (!status) return false;
        done_ += job.run.estimate.seconds;
        const std::string took = duration_text(wall_clock() - job.start);
        if (*status == 0)
            ++end_.finished, say(job.run, "finished in " + took);
        else if (*status == kExitStopped)
            ++end_.stopped, say(job.run, "stopped after " + took);
        else
            fail(job.run, why_failed(job.run, *status));
        return true;
    }
    void fail(const SweepRun& run, const std::string& why) {
        ++end_.failed;
        io::write_text(run.failure(), why + "\n");
        say(run, "failed: " + why);
    }
    void say(const SweepRun& run, const std::string& what) {
        line_.finish();
        notice(fmt::format("{}: {}", plan_.name(run), what));
    }
    // By what the runs that have ended were estimated to take, and took.
    std::string left(double now) const {
        if (done_ <= 0 || done_ >= work_) return "";
        return "  " + duration_text((now - start_) * (work_ - done_) / done_) + " left";
    }
    void tell_progress() {
        const double now = wall_clock();
        if (!line_.due(now)) return;
        const std::size_t ended = next_ - jobs_.size();
        std::string text = fmt::format("{} of {} runs, {} going on", ended, runs_.size(), jobs_.size());
        if (end_.failed > 0) text += fmt::format(", {} failed", end_.failed);
        line_.show(text + (end_.interrupted ? ", stopping" : left(now)), now);
    }

    const SweepPlan& plan_;
    const std::vector<const SweepRun*>& runs_;
    QueueOptions options_;
    std::list<Job> jobs_;
    std::size_t next_ = 0;
    QueueEnd end_;
    double work_ = 0, done_ = 0, start_ = wall_clock();  // [s]; work: as estimated
    LiveLine line_;
};

}  // namespace

QueueEnd run_queue(const SweepPlan& plan, const std::vector<const SweepRun*>& runs,
                   const QueueOptions& options) {
    catch_interrupts();
    return Queue(plan, runs, options).run();
}

}  // namespace sandgraph::simulation

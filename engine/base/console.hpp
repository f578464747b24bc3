#pragma once
#include <cstddef>
#include <cstdio>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>

#include "base/process.hpp"

// All that the program writes to a terminal goes through here: results to stdout, notices and progress to
// stderr.
namespace sandgraph {

void tell(std::string_view text);    // a result, to stdout, as it is
void notice(std::string_view line);  // a line to stderr: what the user should know beside the result

double wall_clock();  // [s], steady

// A line that renews itself on a terminal; elsewhere a plain line now and then.
class LiveLine {
  public:
    explicit LiveLine(std::FILE* out = stderr);
    ~LiveLine() { finish(); }
    LiveLine(const LiveLine&) = delete;
    LiveLine& operator=(const LiveLine&) = delete;

    bool due(double now) const { return now >= next_; }  // is it time to show again? [s], any origin
    void show(const std::string& text, double now);
    void finish();  // ends the live line

  private:
    std::FILE* out_;
    bool terminal_, live_ = false;
    double next_ = 0;
};

// Told now and then by long work: what is going on and how far it is (0 to 1).
using ProgressCallback = std::function<void(std::string_view stage, double fraction)>;

// Progress of a preparation on a live line: "12 s  consolidating 40 %". Asked to stop (Ctrl-C), the next
// update throws Interrupted.
class StageProgress {
  public:
    StageProgress() { catch_interrupts(); }
    void update(std::string_view stage, double fraction);
    ProgressCallback callback() {
        return [this](std::string_view stage, double fraction) { update(stage, fraction); };
    }

  private:
    LiveLine line_;
    double start_ = wall_clock();
};

// Counts finished pieces of work of all threads and tells the share done.
class Tally {
  public:
    Tally(std::size_t all, const ProgressCallback& progress) : all_(all), progress_(progress) {}
    void done(std::string_view stage);

  private:
    std::size_t all_, done_ = 0;
    const ProgressCallback& progress_;
    std::mutex telling_;
};

}  // namespace sandgraph

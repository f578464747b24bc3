#pragma once
#include <cstdio>
#include <string>

namespace sandgraph::app {

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

double wall_clock();  // [s], steady

}  // namespace sandgraph::app

#pragma once
#include <cstddef>
#include <mutex>
#include <string>

#include "dem/prepare.hpp"

namespace sandgraph::app {

// Counts finished pieces of work of all threads and tells the share done.
class Tally {
  public:
    Tally(std::size_t all, const dem::Progress& progress) : all_(all), progress_(progress) {}
    void done(const std::string& stage) {
        const std::lock_guard lock(telling_);
        ++done_;
        if (progress_) progress_(stage, static_cast<double>(done_) / static_cast<double>(all_));
    }

  private:
    std::size_t all_, done_ = 0;
    const dem::Progress& progress_;
    std::mutex telling_;
};

}  // namespace sandgraph::app

#pragma once
#include <filesystem>
#include <functional>
#include <string>

#include "base/archive.hpp"
#include "base/console.hpp"

namespace sandgraph::simulation {

// The checkpoint in a run folder: when it is due, how it is written and read.
class RunCheckpoint {
  public:
    using Parts = std::function<void(Archive&)>;  // passes everything that a run goes on from

    // `every`: wall time between two [s].
    RunCheckpoint(std::filesystem::path folder, std::string scene_hash, double every);
    bool due() const { return wall_clock() - last_ > every_; }
    void write(double d_over_B, const Parts& parts);
    // InputError when there is none of this program and scene.
    void read(const Parts& parts) const;

  private:
    std::filesystem::path folder_;
    std::string scene_hash_;
    double every_, last_ = wall_clock();
};

}  // namespace sandgraph::simulation

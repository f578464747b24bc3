#pragma once
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "io/summary.hpp"
#include "simulation/sweep_plan.hpp"

// Sweeps of which no run is made: their folders hold summaries that a test writes.
namespace sandgraph::support {

namespace fs = std::filesystem;

class SmallSweep {
  public:
    explicit SmallSweep(const std::string& name)
        : folder_(fs::temp_directory_path() / fmt::format("sandgraph_sweep_{}", name)) {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        std::ofstream(folder_ / "s.toml") << "[domain]\nwidth = \"4 m\"\ndepth = \"4 m\"\ncell = \"0.25 m\"\n"
                                             "[anchor]\nembedment_ratio = 1\nthickness = \"0.25 m\"\n";
    }
    ~SmallSweep() { fs::remove_all(folder_); }
    SmallSweep(const SmallSweep&) = delete;
    SmallSweep& operator=(const SmallSweep&) = delete;

    simulation::SweepPlan plan(const std::string& table) const {
        std::ofstream(folder_ / "t.toml") << "scene = \"s.toml\"\n" << table;
        return simulation::plan_sweep((folder_ / "t.toml").string(), folder_ / "out");
    }
    // As a run that has broken out with this factor leaves it.
    static void finish(const simulation::SweepRun& run, double n_gamma) {
        io::Summary s;
        s.scene_hash = run.scene_hash, s.breakout = true, s.n_gamma = n_gamma;
        s.breakout_load = 1000 * n_gamma, s.breakout_d_over_B = 0.02, s.late_load = 500;
        s.n_gamma_meyerhof_adams = 2.5, s.n_gamma_biarez = 7, s.cpu_s = 3, s.dem_steps = 100;
        s.warnings = {"coarse"};
        finish(run, s);
    }
    static void finish(const simulation::SweepRun& run, const io::Summary& summary) {
        fs::create_directories(run.folder());
        io::write_summary(run.folder() / "summary.json", summary);
    }
    const fs::path& folder() const { return folder_; }

  private:
    fs::path folder_;
};

}  // namespace sandgraph::support

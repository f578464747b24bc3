#pragma once
#include <filesystem>

#include "io/region_series.hpp"
#include "scene/scene.hpp"
#include "simulation/background_writer.hpp"
#include "simulation/simulation.hpp"

namespace sandgraph::simulation {

// Follows the scene's regions: their material points are chosen before the first step and stay the same.
class RegionRecorder {
  public:
    // InputError for a region without material points.
    RegionRecorder(const scene::Scene& scene, const Simulation& simulation, double initial_porosity);
    // The regions by name, without rows.
    const std::vector<io::RegionSeries>& regions() const { return regions_; }
    std::vector<io::RegionRow> rows(const Simulation& simulation) const;  // one a region
    // Posts packings/NAME_DDDD.h5 (DDDD: 1000 d/B, without an anchor ms) for every mark that the last step
    // passed.
    void keep_packings(const Simulation& simulation, const std::filesystem::path& folder,
                       BackgroundWriter& writer);
    bool keeps_by(double mark) const;  // a packing
    // A resumed run goes on behind this mark.
    void resume_at(double mark) { kept_to_ = mark; }

  private:
    struct Members {
        std::vector<std::size_t> points;
        std::size_t middle = 0;  // the point nearest to the middle of the region
        std::vector<double> packings;
    };
    io::RegionRow row(const Simulation& simulation, const Members& members) const;
    bool passed(double mark, double now) const;
    void keep(const Simulation& simulation, std::size_t region, double mark,
              const std::filesystem::path& folder, BackgroundWriter& writer) const;

    const dem::Material material_;
    double initial_porosity_, kept_to_ = -1;
    std::vector<io::RegionSeries> regions_;
    std::vector<Members> members_;
};

}  // namespace sandgraph::simulation

#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "io/frame.hpp"
#include "io/h5_group.hpp"
#include "io/region_series.hpp"
#include "io/screening_record.hpp"

namespace sandgraph::io {

// Where a run came from.
struct RunInfo {
    std::string scene_text, scene_hash, version, git, mode;
    int threads = 1;
};

// A run without its frames, which are read one by one.
struct RunRecord {
    RunInfo info;
    std::vector<LoadRow> load;
    std::map<std::string, double> timing;    // phase -> wall time [s]
    std::map<std::string, double> counters;  // of the RVEs: name -> count
    std::size_t frames = 0;
    ScreeningRecord screening;
    std::vector<RegionSeries> regions;  // by name
    bool load_audited = false;          // the law tells its load's error: columns of their own
};

// The groups /scene, /load, /timing, /rve, those of regions and of a screening run, and an empty /frames of
// run.h5.
void write_run_groups(h5::Group root, const RunRecord& record);

// InputError when run.h5 is missing, damaged or of another schema.
RunRecord read_run(const std::filesystem::path& run_h5);
Frame read_run_frame(const std::filesystem::path& run_h5, std::size_t index);

}  // namespace sandgraph::io

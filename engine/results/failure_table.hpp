#pragma once
#include <string>
#include <vector>

#include "results/failure_pattern.hpp"
#include "results/finished_run.hpp"
#include "results/slip_surface.hpp"

namespace sandgraph::results {

// One frame of a run, measured by report/failure_pattern.hpp and report/slip_surface.hpp.
struct FailureRow {
    double d_over_B = 0;
    SurfaceShape surface;
    StrainedZone zone;
    double cavity = 0, rotation = 0;
    ShearBand total, recent;  // of the whole strain, and of that since the frame before
    SlipSurface slip;
};

// Every frame but the first. Cavity, bands and slip surface are those of a horizontal plate, NaN for a
// vertical one.
std::vector<FailureRow> failure_rows(const FinishedRun& run);

// One line a frame of every run found: run,d_over_B,heave_highest,...
std::string failure_csv(const std::vector<std::string>& folders);

}  // namespace sandgraph::results

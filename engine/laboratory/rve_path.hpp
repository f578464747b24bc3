#pragma once
#include <vector>

#include "dem/element_test/element_test.hpp"
#include "dem/rve.hpp"

namespace sandgraph::laboratory {

// The strain path of `test` on an RVE as a run drives it: the increments F_inc = I + dt L of a segment are
// collected up to `collect` of strain and then followed by as many DEM steps as `options` ask for. Rows show
// the deformation reached. `sample` is at rest (relaxed before, if wanted; relax_steps is not used here).
struct RvePath {
    dem::PathTest test;
    dem::Material material;
    dem::RveOptions options;
    double collect = 2e-4;
};
std::vector<dem::ElementRow> run_rve_path(const dem::Packing& sample, const Mat2& stress,
                                          const RvePath& path);

}  // namespace sandgraph::laboratory

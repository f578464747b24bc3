#include <algorithm>

#include "base/contracts.hpp"
#include "dem/element_test/sample.hpp"

namespace sandgraph::dem {
namespace {

// Steps to the next multiple of `every`, but not past the end of the segment.
int stretch(std::int64_t at, int every, std::int64_t left) {
    SG_EXPECT(at >= 0 && every > 0 && left > 0);
    return static_cast<int>(std::min<std::int64_t>(every - at % every, left));
}

}  // namespace

std::vector<ElementRow> run_path(Assembly& assembly, const PathTest& test) {
    SG_EXPECT(test.sample_every > 0 && test.time_step > 0);
    assembly.step(Mat2::Zero(), test.time_step, test.relax_steps);
    SampleOnStand sample(assembly, test.time_step);
    std::vector<ElementRow> rows{sample.row()};
    for (const PathSegment& segment : test.segments)
        for (std::int64_t left = segment.steps; left > 0;) {
            const int count = stretch(sample.steps(), test.sample_every, left);
            sample.step(segment.velocity_gradient, count);
            left -= count;
            if (sample.steps() % test.sample_every == 0) rows.push_back(sample.row());
        }
    if (rows.back().step != sample.steps()) rows.push_back(sample.row());
    return rows;
}

}  // namespace sandgraph::dem

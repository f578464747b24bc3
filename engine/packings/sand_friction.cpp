#include "packings/sand_friction.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <vector>

#include "base/contracts.hpp"
#include "base/statistics.hpp"
#include "packings/compressed_packings.hpp"

namespace sandgraph::packings {
namespace {

constexpr std::size_t kSample =
    6;  // packings; their angles scatter by 2 deg (sd), the mean of six to 2 deg (95 %)

}  // namespace

FrictionSample friction_sample(std::span<const double> angles) {
    SG_EXPECT(!angles.empty());
    const Sample sample = sample_of(angles);
    return {.mean = sample.mean, .ci95 = sample.ci95, .packings = static_cast<int>(sample.count)};
}

FrictionSample sampled_friction(const scene::Grains& grains, std::span<const double> known,
                                const ProgressCallback& progress) {
    SG_EXPECT(!known.empty());
    std::vector<double> angles(known.begin(), known.end());
    const std::size_t first = angles.size();
    if (grains.packing.empty()) angles.resize(std::max(first, kSample));
    Tally tally(std::max<std::size_t>(angles.size() - first, 1), progress);
    tbb::parallel_for(first, angles.size(), [&](std::size_t k) {
        scene::Grains one = grains;
        one.seed += k;
        const CompressedPackings packings(one);
        angles[k] = packings.friction();
        tally.done("friction of several packings");
    });
    return friction_sample(angles);
}

}  // namespace sandgraph::packings

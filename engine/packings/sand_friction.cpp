#include "packings/sand_friction.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "base/contracts.hpp"
#include "packings/compressed_packings.hpp"

namespace sandgraph::packings {
namespace {

constexpr std::size_t kSample =
    6;  // packings; their angles scatter by 2 deg (sd), the mean of six to 2 deg (95 %)

// Two-sided 95 % quantile of Student's t, by degrees of freedom.
double student(std::size_t freedom) {
    constexpr std::array quantiles{12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262};
    return freedom <= quantiles.size() ? quantiles[freedom - 1] : 1.96 + 2.5 / static_cast<double>(freedom);
}

}  // namespace

FrictionSample friction_sample(std::span<const double> angles) {
    SG_EXPECT(!angles.empty());
    const auto n = static_cast<double>(angles.size());
    FrictionSample out{.mean = std::accumulate(angles.begin(), angles.end(), 0.0) / n,
                       .packings = static_cast<int>(angles.size())};
    if (angles.size() < 2) return out;
    double squares = 0;
    for (const double angle : angles) squares += (angle - out.mean) * (angle - out.mean);
    out.ci95 = student(angles.size() - 1) * std::sqrt(squares / (n - 1) / n);
    return out;
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

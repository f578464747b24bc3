#pragma once
#include <limits>
#include <span>

#include "base/console.hpp"
#include "scene/scene.hpp"

namespace sandgraph::packings {

// Peak friction angle of a sand: the mean over several packings, for that of one moves by 2 to 6 deg with
// what should not matter (seed, grain density, thickness of the disks).
struct FrictionSample {
    double mean = 0;  // [rad]
    double ci95 =
        std::numeric_limits<double>::quiet_NaN();  // half of the 95 % interval of the mean [rad]; NaN of one
    int packings = 0;                              // 0: the angle of a closed-form law
};

// Over the packings in use, whose angles are `known` [rad], and with them six at least: the others are of the
// same recipe with the next seeds. A packing file is one packing. Cached.
FrictionSample sampled_friction(const scene::Grains& grains, std::span<const double> known,
                                const ProgressCallback& progress);

// Of angles of one sand [rad], at least one.
FrictionSample friction_sample(std::span<const double> angles);

}  // namespace sandgraph::packings

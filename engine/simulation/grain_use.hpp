#pragma once
#include <cstdint>

#include "stress/law.hpp"

namespace sandgraph::simulation {

// What a law does with grains, whichever law it is; zeros for closed-form laws.
struct GrainUse {
    std::int64_t active = 0;     // full fidelity: points that own a packing; screening: answered by grains
    std::int64_t dem_steps = 0;  // of all packings since the start, shadows and audits included
    std::int64_t updates = 0, failures = 0;  // of the packings that answer
};
GrainUse grain_use(const stress::Law& law);

}  // namespace sandgraph::simulation

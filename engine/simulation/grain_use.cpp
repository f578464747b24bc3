#include "simulation/grain_use.hpp"

#include "graph/screening_law.hpp"

namespace sandgraph::simulation {

GrainUse grain_use(const stress::Law& law) {
    if (const auto* full = dynamic_cast<const graph::RveLaw*>(&law))
        return {static_cast<std::int64_t>(full->owning()), full->counters().dem_steps,
                full->counters().updates, full->counters().failures};
    if (const auto* screening = dynamic_cast<const graph::ScreeningLaw*>(&law))
        return {static_cast<std::int64_t>(screening->grain_points()), screening->dem_steps(),
                screening->counters().updates, screening->counters().failures};
    return {};
}

}  // namespace sandgraph::simulation

#include "simulation/point_sight.hpp"

#include "graph/rve_law.hpp"
#include "graph/screening_law.hpp"

namespace sandgraph::simulation {

double point_porosity(const graph::Pull& pull, std::size_t point, double initial_porosity) {
    const graph::GroundState& s = pull.state();
    if (const auto* rve = dynamic_cast<const graph::RveLaw*>(s.law.get())) return rve->porosity(point);
    if (const auto* screening = dynamic_cast<const graph::ScreeningLaw*>(s.law.get()))
        return screening->porosity(point);
    return 1 - (1 - initial_porosity) * s.points.volume0[point] / s.points.volume[point];
}

std::optional<dem::Observables> point_packing(const graph::Pull& pull, std::size_t point) {
    const auto* rve = dynamic_cast<const graph::RveLaw*>(pull.state().law.get());
    return rve ? std::optional(rve->observe(point)) : std::nullopt;
}

}  // namespace sandgraph::simulation

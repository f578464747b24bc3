#include "graph/ground_state.hpp"

namespace sandgraph::graph {

GroundState::GroundState(StepSettings step_settings, mpm::Points ground, const mpm::GridShape& shape)
    : settings(step_settings),
      points(std::move(ground)),
      grid(shape),
      contact(mpm::make_contact(points.size())),
      all_points(points.size()) {
    std::iota(all_points.begin(), all_points.end(), 0);
    if (!points.mass.empty()) grid.point_mass = points.mass.front();
}

void GroundState::archive(Archive& a) {
    mpm::archive(a, points);
    mpm::archive(a, plate);
    mpm::archive(a, contact);
    std::vector<double> work = {stress_work};
    field_of_known_length(a, "work", work);
    stress_work = work.front();
    law->archive(a);
    if (a.reading()) order.stale = true;
}

}  // namespace sandgraph::graph

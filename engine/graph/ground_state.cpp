#include "graph/ground_state.hpp"

#include "mpm/light_nodes.hpp"

namespace sandgraph::graph {

GroundState::GroundState(StepSettings step_settings, mpm::Points ground, const mpm::GridShape& shape)
    : settings(step_settings), points(std::move(ground)), grid(shape), all_points(points.size()) {
    std::iota(all_points.begin(), all_points.end(), 0);
    if (points.size() == 0) return;
    grid.point_mass = points.mass.front() / mpm::share(points, 0);
    if (settings.scheme.light_nodes) light = mpm::light_mass(points, shape);
    const bool several = 2 * points.half < 0.75 * shape.cell;
    means = mpm::CellMean(several ? settings.scheme.hourglass : 1);
}

void GroundState::add_body(const mpm::RigidPlate& plate) {
    bodies.push_back({plate, mpm::make_contact(plate, points)});
}

void GroundState::archive(Archive& a) {
    mpm::archive(a, points);
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        const std::string prefix = k == 0 ? "" : "body" + std::to_string(k) + "/";
        mpm::archive(a, bodies[k].plate, prefix);
        mpm::archive(a, bodies[k].contact, prefix);
    }
    std::vector<double> work = {stress_work, node_work.damping, node_work.gained};
    field_of_known_length(a, "work", work);
    stress_work = work[0], node_work = {work[1], work[2]};
    law->archive(a);
    bands.archive(a);
    if (a.reading()) order.stale = true;
}

}  // namespace sandgraph::graph

#include "graph/ground_state.hpp"

#include <stdexcept>

namespace sandgraph::graph {

GroundState::GroundState(StepSettings step_settings, mpm::Points ground, const mpm::GridShape& shape)
    : settings(step_settings), points(std::move(ground)), grid(shape), all_points(points.size()) {
    std::iota(all_points.begin(), all_points.end(), 0);
    if (!points.mass.empty()) grid.point_mass = points.mass.front();
}

void GroundState::add_body(const mpm::RigidPlate& plate) {
    if (!bodies.empty()) throw std::logic_error("a second rigid body: the grid has one enriched field only");
    bodies.push_back({plate, mpm::make_contact(points.size())});
}

void GroundState::archive(Archive& a) {
    mpm::archive(a, points);
    for (Body& body : bodies) {
        mpm::archive(a, body.plate);
        mpm::archive(a, body.contact);
    }
    std::vector<double> work = {stress_work};
    field_of_known_length(a, "work", work);
    stress_work = work.front();
    law->archive(a);
    if (a.reading()) order.stale = true;
}

}  // namespace sandgraph::graph

#include "mpm/plate.hpp"

#include "base/contracts.hpp"

namespace sandgraph::mpm {

Enrichment enrichment_of(const RigidPlate& plate) {
    SG_EXPECT(plate.half_width >= 0 && plate.half_height >= 0);
    if (plate.round) {  // nothing is cut: it is thicker than a stencil
        return {true, true, plate.y, plate.x - plate.half_width, plate.x + plate.half_width, plate.half_width,
                0};
    }
    const bool along_x = plate.half_width >= plate.half_height;
    const double middle = along_x ? plate.x : plate.y, half = along_x ? plate.half_width : plate.half_height;
    return {true,
            along_x,
            along_x ? plate.y : plate.x,
            middle - half,
            middle + half,
            along_x ? plate.half_height : plate.half_width,
            0};
}

void advance(RigidPlate& plate, double dt) {
    plate.x += dt * plate.velocity.x();
    plate.y += dt * plate.velocity.y();
}

void archive(Archive& a, RigidPlate& plate, const std::string& prefix) {
    RestPressure& r = plate.rest;
    double* const values[] = {
        &plate.x,           &plate.y,           &plate.half_width,     &plate.half_height,
        &plate.velocity[0], &plate.velocity[1], &plate.friction_angle, &plate.stiffness,
        &r.vertical,        &r.horizontal,      &r.vertical_gradient,  &r.horizontal_gradient};
    std::vector<double> flat;
    for (const double* v : values) flat.push_back(*v);
    field_of_known_length(a, prefix + "plate/state", flat);
    for (std::size_t k = 0; k < std::size(values); ++k) *values[k] = flat[k];
}

}  // namespace sandgraph::mpm

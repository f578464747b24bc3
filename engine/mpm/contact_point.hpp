#pragma once
#include <cstdint>

#include "mpm/plate.hpp"
#include "mpm/points.hpp"
#include "mpm/stencil.hpp"

namespace sandgraph::mpm {

enum class Face : std::uint8_t { none, top, bottom, left, right, round };  // round: of a circle
inline constexpr std::size_t kFaces = 6;

// One material point in contact with the plate in this step.
struct ContactPoint {
    std::int32_t point = 0;
    Face face = Face::none;
    Vec2 normal = Vec2::Zero();  // out of the plate
    double penetration = 0;      // with the rest pressure's share [m], positive
    double length = 0;           // of the point's domain along the face [m]
    Stencil stencil;             // nodes that carry the force
    // At an end of the face the force acts on the nodes beside the face alone: those beyond it feel the plate
    // through the ground. The ground's velocity then falls from the plate's to its own between the last node
    // beside the face and the first beyond, on the mean at the end itself where that is midway. With all
    // nodes of the hat functions it falls over the cell beyond: a plate as wide as B + a cell. The pressure
    // at rest acts on all of them, as that of the ground beyond does (contact.cpp, at_rest), over the whole
    // edge of a domain of which the end halves the length: its other half presses a half point, spread as
    // widely.
    bool at_end = false;
    double rest = 0;     // penetration of the rest pressure [m]
    Stencil whole, own;  // if at_end: all nodes at the contact, and those of the point itself
};

// The point's contact with the plate: the face that it penetrates least, or Face::none. The length along the
// face is the overlap with the bare plate, so that the loaded width is exactly the plate's.
ContactPoint find_contact_point(const RigidPlate& plate, const Points& points, std::int32_t id,
                                const Grid& grid);

// Points of the ground that has just been laid out around a circle stand on a staircase: they are taken to
// touch it. How far each penetrates it by that [m]; NaN: it does not touch.
double bedding(const RigidPlate& plate, const Points& points, std::size_t p);

// Outward normal of a straight face.
Vec2 normal(Face face);
inline bool horizontal(Face face) { return face == Face::top || face == Face::bottom; }

}  // namespace sandgraph::mpm

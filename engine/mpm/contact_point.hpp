#pragma once
#include <cstdint>

#include "mpm/plate.hpp"
#include "mpm/points.hpp"
#include "mpm/stencil.hpp"

namespace sandgraph::mpm {

enum class Face : std::uint8_t { none, top, bottom, left, right };
inline constexpr std::size_t kFaces = 5;

// One material point in contact with the plate in this step.
struct ContactPoint {
    std::int32_t point = 0;
    Face face = Face::none;
    double penetration = 0;  // with the rest pressure's share [m], positive
    double length = 0;       // of the point's domain along the face [m]
    Stencil stencil;         // nodes that carry the force
};

// The point's contact with the plate: the face that it penetrates least, or Face::none. The length along the
// face is the overlap with the bare plate, so that the loaded width is exactly the plate's.
ContactPoint find_contact_point(const RigidPlate& plate, const Points& points, std::int32_t id,
                                const Grid& grid);

// Outward normal of a face.
Vec2 normal(Face face);
inline bool horizontal(Face face) { return face == Face::top || face == Face::bottom; }

}  // namespace sandgraph::mpm

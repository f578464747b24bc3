#pragma once
#include "mpm/contact.hpp"

namespace sandgraph::mpm {

// The point's contact with the plate: the face that it penetrates least, or Face::none. The length along the
// face is the overlap with the bare plate, so that the loaded width is exactly the plate's.
Touch find_touch(const RigidPlate& plate, const Points& points, std::int32_t id, const Grid& grid);

// Outward normal of a face.
Vec2 normal(Face face);
inline bool horizontal(Face face) { return face == Face::top || face == Face::bottom; }

}  // namespace sandgraph::mpm

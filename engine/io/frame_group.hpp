#pragma once
#include <string>

#include "io/frame.hpp"
#include "io/h5_group.hpp"

namespace sandgraph::io {

std::string frame_name(std::size_t index);  // "0000", "0001", ...

// One frame as a group: attributes time [s], d_over_B, plate_x, plate_y [m]; datasets `position` (N x 2) [m]
// and each field (N or N x components) with its unit.
void write_frame(h5::Group group, const Frame& frame);
Frame read_frame(const h5::Group& group);

}  // namespace sandgraph::io

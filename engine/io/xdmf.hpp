#pragma once
#include <filesystem>

#include "io/h5_group.hpp"

namespace sandgraph::io {

// XDMF 3 for ParaView: a temporal collection, one Polyvertex grid a frame, 2D geometry and every field, all
// as references into run.h5 beside it. The vertices are listed (/points/id): readers built on the Xdmf3
// library make no cells of a topology without its list. Vectors (plane_vector) are Vector attributes, other
// fields of several components Matrix ones: XDMF's Tensor means 9 components.
// /points/id, 0 to n - 1, of the frames in the file, which the topology of every frame refers to; nothing
// where there is no frame. It belongs into each run.h5, after the frames.
void write_point_ids(h5::Group root);

// InputError when run.h5 is missing, damaged, or has frames without /points/id.
void write_xdmf(const std::filesystem::path& xdmf, const std::filesystem::path& run_h5);

}  // namespace sandgraph::io

#pragma once
#include <filesystem>

namespace sandgraph::io {

// XDMF 3 for ParaView: a temporal collection, one Polyvertex grid a frame, 2D geometry and every field, all
// as references into run.h5 beside it. Fields of several components appear as
// Matrix attributes: XDMF's Vector and Tensor mean 3 and 9 components.
void write_xdmf(const std::filesystem::path& xdmf, const std::filesystem::path& run_h5);

}  // namespace sandgraph::io

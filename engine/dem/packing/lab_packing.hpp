#pragma once
#include "dem/packing/packing.hpp"
#include "dem/rve.hpp"

namespace sandgraph::dem {

// The packing behind a material point as it lies in the lab frame (the Rve keeps it in a frame that turns
// with the point), with its contact history. A floating packing is shown as it last carried load.
Packing lab_packing(const Rve& rve);

}  // namespace sandgraph::dem

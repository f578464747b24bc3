#pragma once
#include "dem/material.hpp"
#include "io/h5_group.hpp"

namespace sandgraph::io {

// The contact parameters as attributes, SI units, angles in rad.
void write_material(h5::Group group, const dem::Material& material);
// InputError when a parameter is missing or out of its range.
dem::Material read_material(const h5::Group& group);

}  // namespace sandgraph::io

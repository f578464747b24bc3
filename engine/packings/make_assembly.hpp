#pragma once
#include <memory>

#include "dem/assembly.hpp"
#include "scene/element_test_spec.hpp"

namespace sandgraph::packings {

std::unique_ptr<dem::Assembly> make_assembly(scene::Kernel kernel, const dem::Packing& packing,
                                             const dem::Material& material);

}  // namespace sandgraph::packings

#pragma once
#include <memory>

#include "dem/assembly.hpp"

namespace sandgraph::dem {

// The published step (YADE's, to round-off), the optimised kernel, or that in mixed precision.
enum class Kernel { reference, fast, mixed };

std::unique_ptr<Assembly> make_assembly(Kernel kernel, const Packing& packing, const Material& material);

// Packings are prepared and measured with the optimised kernel.
AssemblyFactory fast_assemblies();

}  // namespace sandgraph::dem

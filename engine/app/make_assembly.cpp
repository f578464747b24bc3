#include "app/make_assembly.hpp"

#include "dem/fast.hpp"
#include "dem/reference.hpp"

namespace sandgraph::app {

std::unique_ptr<dem::Assembly> make_assembly(scene::Kernel kernel, const dem::Packing& packing,
                                             const dem::Material& material) {
    if (kernel == scene::Kernel::reference)
        return std::make_unique<dem::ReferenceAssembly>(packing, material);
    return std::make_unique<dem::FastAssembly>(packing, material);
}

}  // namespace sandgraph::app

#include "packings/make_assembly.hpp"

#include "dem/fast/fast.hpp"
#include "dem/reference/reference.hpp"

namespace sandgraph::packings {

std::unique_ptr<dem::Assembly> make_assembly(scene::Kernel kernel, const dem::Packing& packing,
                                             const dem::Material& material) {
    if (kernel == scene::Kernel::reference)
        return std::make_unique<dem::ReferenceAssembly>(packing, material);
    return std::make_unique<dem::FastAssembly>(packing, material);
}

}  // namespace sandgraph::packings

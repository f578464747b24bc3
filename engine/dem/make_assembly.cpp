#include "dem/make_assembly.hpp"

#include "dem/fast/fast.hpp"
#include "dem/mixed/assembly.hpp"
#include "dem/reference/reference.hpp"

namespace sandgraph::dem {

std::unique_ptr<Assembly> make_assembly(Kernel kernel, const Packing& packing, const Material& material) {
    if (kernel == Kernel::reference) return std::make_unique<ReferenceAssembly>(packing, material);
    if (kernel == Kernel::mixed) return std::make_unique<MixedAssembly>(packing, material);
    return std::make_unique<FastAssembly>(packing, material);
}

AssemblyFactory fast_assemblies() {
    return [](const Packing& packing, const Material& material) {
        return make_assembly(Kernel::fast, packing, material);
    };
}

}  // namespace sandgraph::dem

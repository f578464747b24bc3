#include "dem/observe.hpp"
#include "dem/stretch.hpp"

namespace sandgraph::dem {

// The packing lies in its own frame, which turned with the point.
Observables observe(const Rve& rve, const Material& material) {
    const Packing packing = to_packing(rve.packing());
    Observables seen = observe(packing, contact_forces(packing, material), material);
    seen.stress = rve.stress();
    seen.fabric = turned(seen.fabric, rve.angle());
    seen.porosity = rve.porosity();
    return seen;
}

}  // namespace sandgraph::dem

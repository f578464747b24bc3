#pragma once
#include <functional>
#include <memory>

#include "dem/material.hpp"
#include "dem/packing/observables.hpp"
#include "dem/packing/packing.hpp"

namespace sandgraph::dem {

// A packing in motion. Two kernels stand behind it: the reference step (YADE's, to round-off) and the fast
// one.
class Assembly {
  public:
    virtual ~Assembly() = default;
    // `count` DEM steps of `dt` [s] under the constant velocity gradient L_ij = dv_i/dx_j [1/s].
    // The order inside a step (cell moved with the previous L, forces, then the new L) is YADE's.
    virtual void step(const Mat2& L, double dt, int count) = 0;
    // Love-Weber stress of the last force evaluation [Pa], compression positive, not symmetrised.
    virtual Mat2 stress() = 0;
    // Full set at the last force evaluation (slow; for output).
    virtual Observables observe() = 0;
    virtual Mat2 cell() const = 0;  // H at the last force evaluation
    virtual Packing packing() const = 0;
    virtual void set_friction(double tangent) = 0;  // for preparation stages
};

// Makes the assembly that does the work, so that any kernel can prepare packings.
using AssemblyFactory = std::function<std::unique_ptr<Assembly>(const Packing&, const Material&)>;

}  // namespace sandgraph::dem

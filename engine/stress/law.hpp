#pragma once
#include <cstdint>
#include <span>

#include "base/archive.hpp"
#include "base/tensor.hpp"

namespace sandgraph::stress {

// THE contract between the ground (mpm) and what it is made of: a batch of (point, strain increment) in,
// stress out. RVEs, closed-form laws and the surrogate all stand behind it.
struct Batch {
    std::span<const std::int32_t> points;  // ids of the material points to update, each at most once
    std::span<const Mat2> F_inc;  // by point id: increment of the deformation gradient since last step
    std::span<Stress> stress;     // by point id: Cauchy stress [Pa], tension positive; in: old, out: new
    double dt = 0;                // [s]
};

class Law {
  public:
    virtual ~Law() = default;
    // Initial stress of the points in `batch.points` (F_inc unused): what the law holds before any strain.
    virtual void initialise(const Batch& batch) = 0;
    // Must give the same bits for any split of the points into batches and any thread count.
    virtual void update(const Batch& batch) = 0;
    // Largest P-wave modulus [Pa], for the time step.
    virtual double p_wave_modulus() const = 0;
    virtual void archive(Archive&) {}
};

}  // namespace sandgraph::stress

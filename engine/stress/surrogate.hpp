#pragma once
#include <cstdint>
#include <span>

#include "base/tensor.hpp"

namespace sandgraph::stress {

// What is known of a packing before its point strains; constants of a surrogate's state.
struct PackingTraits {
    double pressure = 0;                  // mean stress at the start [Pa], compression positive
    double porosity = 0;                  // 2D, at the start
    double bulk = 0, shear = 0;           // small-strain moduli in the plane [Pa]
    double coordination = 0;              // Z = 2 Nc / N
    double fabric_xx = 0, fabric_xy = 0;  // deviator of the contact fabric: (f_xx - f_yy)/2 and f_xy
    double peak_friction = 0;             // sin(phi) at the peak of a biaxial test on the base packing
};

// What a surrogate says of one point after an update.
struct SurrogateAnswer {
    Stress stress;        // mean of the ensemble [Pa], tension positive, lab frame
    double spread = 0;    // of the ensemble: rms distance of the members' stresses from the mean, share of p
    double distance = 0;  // largest feature outside the trained range, in widths of that range; 0 inside
};

// d(stress)/d(strain) of the next small increment, rows and columns xx, yy, xy (engineering shear strain).
using Tangent = Eigen::Matrix3d;

// A learned stress law that stands in for packings of grains. It knows no points: whoever uses it owns the
// states, `state_size()` doubles a point, and may copy them freely. Deterministic: an answer depends on the
// point's own state and increment only, never on batch, order or thread.
class Surrogate {
  public:
    virtual ~Surrogate() = default;
    virtual std::size_t state_size() const = 0;
    // State of a point at rest under `initial` [Pa, tension positive]: update by I answers `initial` exactly.
    virtual void start(const PackingTraits& traits, const Stress& initial, std::span<double> state) const = 0;
    // For each slot k: drives point points[k] through F_inc[points[k]] (det > 0), changes its state in
    // `states` [point x state_size] and writes answers[k].
    virtual void update(std::span<const std::int32_t> points, std::span<const Mat2> F_inc,
                        std::span<double> states, std::span<SurrogateAnswer> answers) const = 0;
    // Of the ensemble's mean, for loading on in the direction `strain` (xx, yy, engineering xy).
    virtual Tangent tangent(std::span<const double> state, const Eigen::Vector3d& strain) const = 0;
};

}  // namespace sandgraph::stress

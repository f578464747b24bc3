#pragma once
#include <string>

#include "dem/prepare/prepare.hpp"
#include "graph/rve_law.hpp"
#include "scene/scene.hpp"
#include "stress/surrogate.hpp"

namespace sandgraph::packings {

// The grains of one recipe at any stress, yy at `pressure` [Pa] and xx at k0 times that, through the packing
// cache.
class CompressedPackings {
  public:
    explicit CompressedPackings(const scene::Grains& grains, const ProgressCallback& progress = {});

    dem::Packing at(double pressure, double k0 = 1) const;         // at rest
    graph::RowPacking row(double pressure, double k0 = 1) const;   // with its small-strain moduli
    double friction(const ProgressCallback& progress = {}) const;  // peak angle of the base packing [rad]
    // What is known of `row`, one of this recipe's.
    stress::PackingTraits traits(const graph::RowPacking& row, double friction_angle) const;

    const dem::Packing& base_packing() const { return base_; }

  private:
    graph::PlaneModuli moduli(const dem::Packing& packing, const std::string& stress) const;

    dem::Material material_;
    std::string recipe_;
    dem::Packing base_;
};

}  // namespace sandgraph::packings

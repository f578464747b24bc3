#pragma once
#include <vector>

#include "stress/law.hpp"

namespace sandgraph::stress {

// Isotropic linear elasticity from Young's modulus [Pa] and Poisson's ratio.
struct ElasticConstants {
    double young = 0, poisson = 0;
    double shear() const { return young / (2 * (1 + poisson)); }                           // G
    double lame() const { return young * poisson / ((1 + poisson) * (1 - 2 * poisson)); }  // lambda
    double p_wave() const { return lame() + 2 * shear(); }                                 // M
};

// Isotropic linear elasticity in plane strain: sigma = R (sigma_old + lambda tr(E) I + 2 G E) R^T, F_inc = R
// U, E the strain increment of U (increment.hpp).
class Elastic final : public Law {
  public:
    // `initial` [Pa] by point id, tension positive: what initialise hands out.
    Elastic(const ElasticConstants& constants, std::vector<Stress> initial);
    void initialise(const Batch& batch) override;
    void update(const Batch& batch) override;
    double p_wave_modulus() const override { return constants_.p_wave(); }

  private:
    ElasticConstants constants_;
    std::vector<Stress> initial_;
};

}  // namespace sandgraph::stress

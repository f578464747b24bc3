#pragma once
#include <vector>

#include "stress/law.hpp"
#include "stress/principal_return.hpp"

namespace sandgraph::stress {

// Elastic, perfectly plastic Mohr-Coulomb in plane strain with non-associated flow. sigma_zz is state of
// the law and takes part in the yield condition.
class MohrCoulomb final : public Law {
  public:
    // `initial` and `initial_zz` [Pa] by point id, tension positive.
    MohrCoulomb(const MohrCoulombConstants& constants, std::vector<Stress> initial,
                std::vector<double> initial_zz);
    void initialise(const Batch& batch) override;
    void update(const Batch& batch) override;
    double p_wave_modulus() const override;
    void archive(Archive& a) override;
    double out_of_plane(std::size_t point) const { return zz_[point]; }  // sigma_zz [Pa]

  private:
    MohrCoulombConstants constants_;
    std::vector<Stress> initial_;
    std::vector<double> initial_zz_, zz_;
};

}  // namespace sandgraph::stress

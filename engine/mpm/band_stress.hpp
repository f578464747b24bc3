#pragma once
#include <span>

#include "base/archive.hpp"
#include "mpm/length_mean.hpp"

namespace sandgraph::mpm {

// A stress that resists what a point strains otherwise than the ground around it, so that shear bands get a
// width of their own: beside the law's stress the internal force takes (1 - A) X, A the mean over the length.
// X of a point [Pa] follows the deviatoric strain de of a step as an elastic stress that fades with the
// strain of the surroundings (Armstrong & Frederick 1966, report RD/B/N731, put to de - A de):
//   X <- (R X R^T + k (de - A de)) / (1 + k |A de| / (kappa p)),  p the law's mean stress; 0 where p <= 0.
// In steady flow X = kappa p (D - A D)/|A D|. For a uniform strain or a rotation X does not grow; the rate of
// strain does not matter; no closed path of strain yields work. |.| is the radius of Mohr's circle.
class BandStress {
  public:
    static constexpr double strength = 0.3;    // kappa
    static constexpr double stiffness = 0.25;  // k over the ground's largest P-wave modulus

    BandStress() = default;
    // length [m] (0: nothing is done), p_wave_modulus [Pa], points at the start, cell [m].
    BandStress(double length, double p_wave_modulus, const Points& points, double cell);
    bool active() const { return length_ > 0; }

    // The stress that the internal force takes [Pa], tension positive, by point id, after the last step's
    // strain. The order must be fresh.
    std::span<const Stress> stress(const Points& points, const Order& order, const Grid& grid);
    // Work of the added stress in a step [J/m], from the strain that it has led to: sum V (1 - A) X : de.
    double work(const Points& points) const;
    void archive(Archive& a);

  private:
    void advance(const Points& points, std::size_t p);

    double length_ = 0, modulus_ = 0;
    LengthMean over_;
    std::vector<Deviator> own_, strain_, mean_;  // by point: X [Pa], de; A of the one or the other
    std::vector<Stress> total_;
};

}  // namespace sandgraph::mpm

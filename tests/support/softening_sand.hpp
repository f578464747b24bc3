#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "mpm/points.hpp"
#include "stress/increment.hpp"
#include "stress/law.hpp"
#include "stress/principal_return.hpp"

namespace sandgraph::support {

// Mohr-Coulomb sand that loses strength with shear, as dense packings do: friction and dilation fall in
// proportion to the shear |l1 - l2| that a point has gone through, from peak to residual over `shear`.
struct SofteningConstants {
    stress::MohrCoulombConstants peak, residual;
    double shear = 0.3;
};

class SofteningSand final : public stress::Law {
  public:
    SofteningSand(const SofteningConstants& constants, std::vector<Stress> initial)
        : constants_(constants),
          initial_(std::move(initial)),
          zz_(initial_.size()),
          shear_(initial_.size()) {}

    void initialise(const stress::Batch& batch) override {
        for (const auto id : batch.points) {
            const auto p = static_cast<std::size_t>(id);
            batch.stress[p] = initial_[p], zz_[p] = initial_[p].xx, shear_[p] = 0;
        }
    }
    void update(const stress::Batch& batch) override {
        for (const auto id : batch.points) {
            const auto p = static_cast<std::size_t>(id);
            batch.stress[p] = updated(p, batch.stress[p], stress::increment(batch.F_inc[p]));
        }
    }
    double p_wave_modulus() const override { return constants_.peak.elastic().p_wave(); }
    void archive(Archive& a) override {
        field_of_known_length(a, "softening/stress_zz", zz_);
        field_of_known_length(a, "softening/shear", shear_);
    }
    const std::vector<double>& shear() const { return shear_; }

  private:
    stress::MohrCoulombConstants at(double shear) const {
        const double left = std::max(0.0, 1 - shear / constants_.shear);
        stress::MohrCoulombConstants c = constants_.residual;
        c.friction_angle += left * (constants_.peak.friction_angle - c.friction_angle);
        c.dilation_angle += left * (constants_.peak.dilation_angle - c.dilation_angle);
        return c;
    }
    Stress updated(std::size_t p, const Stress& s, const stress::Increment& e) {
        const stress::ElasticConstants k = constants_.peak.elastic();
        shear_[p] += std::hypot(e.xx - e.yy, 2 * e.xy);
        const double G2 = 2 * k.shear(), bulk = k.lame() * (e.xx + e.yy);
        const double xx = s.xx + bulk + G2 * e.xx, yy = s.yy + bulk + G2 * e.yy, xy = s.xy + G2 * e.xy;
        const double half = 0.5 * (xx - yy), r = std::hypot(half, xy), mean = 0.5 * (xx + yy);
        std::array<double, 3> v = {mean + r, mean - r, zz_[p] + bulk};
        std::array<std::size_t, 3> by = {0, 1, 2};
        std::stable_sort(by.begin(), by.end(), [&](auto a, auto b) { return v[a] > v[b]; });
        const auto back = stress::return_to_yield({v[by[0]], v[by[1]], v[by[2]]}, at(shear_[p]));
        for (std::size_t i = 0; i < 3; ++i) v[by[i]] = back[i];
        zz_[p] = v[2];
        const double m = 0.5 * (v[0] + v[1]), d = r > 0 ? 0.5 * (v[0] - v[1]) / r : 0;
        return stress::rotate({m + d * half, m - d * half, d * xy}, e.cos, e.sin);
    }

    SofteningConstants constants_;
    std::vector<Stress> initial_;
    std::vector<double> zz_, shear_;
};

}  // namespace sandgraph::support

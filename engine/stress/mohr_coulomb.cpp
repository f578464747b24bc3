#include "stress/mohr_coulomb.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/contracts.hpp"
#include "stress/increment.hpp"

namespace sandgraph::stress {
namespace {

// In-plane principal stresses a >= b along directions at angle atan2(sin2, cos2)/2, and sigma_zz.
struct Spectrum {
    double a, b, zz, cos2, sin2;
};

Spectrum spectrum(const Stress& s, double zz) {
    const double mean = 0.5 * (s.xx + s.yy), half = 0.5 * (s.xx - s.yy), radius = std::hypot(half, s.xy);
    const double cos2 = radius > 0 ? half / radius : 1, sin2 = radius > 0 ? s.xy / radius : 0;
    return {mean + radius, mean - radius, zz, cos2, sin2};
}

// Sorts the three, returns them, and puts the results back where they came from.
void return_spectrum(Spectrum& s, const MohrCoulombConstants& constants) {
    Principal sorted;
    const int place = s.zz >= s.a ? 0 : s.zz > s.b ? 1 : 2;  // of zz among a >= b
    if (place == 0) sorted = {s.zz, s.a, s.b};
    if (place == 1) sorted = {s.a, s.zz, s.b};
    if (place == 2) sorted = {s.a, s.b, s.zz};
    sorted = return_to_yield(sorted, constants);
    s.zz = sorted[static_cast<std::size_t>(place)];
    s.a = sorted[place == 0 ? 1 : 0];
    s.b = sorted[place == 2 ? 1 : 2];
}

Stress in_plane(const Spectrum& s) {
    const double mean = 0.5 * (s.a + s.b), radius = 0.5 * (s.a - s.b);
    return {mean + radius * s.cos2, mean - radius * s.cos2, radius * s.sin2};
}

}  // namespace

MohrCoulomb::MohrCoulomb(const MohrCoulombConstants& constants, std::vector<Stress> initial,
                         std::vector<double> initial_zz)
    : constants_(constants),
      initial_(std::move(initial)),
      initial_zz_(std::move(initial_zz)),
      zz_(initial_zz_) {
    SG_EXPECT(constants.young > 0 && constants.poisson > -1 && constants.poisson < 0.5);
    SG_EXPECT(initial_.size() == initial_zz_.size());
}

void MohrCoulomb::initialise(const Batch& batch) {
    SG_EXPECT(distinct_below(batch.points, batch.stress.size()));
    for (const auto id : batch.points) {
        const auto p = static_cast<std::size_t>(id);
        batch.stress[p] = initial_.at(p);
        zz_.at(p) = initial_zz_.at(p);
    }
}

void MohrCoulomb::update(const Batch& batch) {
    SG_EXPECT(distinct_below(batch.points, std::min(batch.stress.size(), zz_.size())));
    SG_EXPECT(batch.F_inc.size() == batch.stress.size());
    const ElasticConstants elastic = constants_.elastic();
    const double lambda = elastic.lame(), G2 = 2 * elastic.shear();
    for (const auto id : batch.points) {
        const auto p = static_cast<std::size_t>(id);
        const Increment e = increment(batch.F_inc[p]);
        const Stress& s = batch.stress[p];
        const double mean = lambda * (e.xx + e.yy);
        Spectrum trial =
            spectrum({s.xx + mean + G2 * e.xx, s.yy + mean + G2 * e.yy, s.xy + G2 * e.xy}, zz_[p] + mean);
        return_spectrum(trial, constants_);
        zz_[p] = trial.zz;
        batch.stress[p] = rotate(in_plane(trial), e.cos, e.sin);
    }
}

double MohrCoulomb::p_wave_modulus() const { return constants_.elastic().p_wave(); }

void MohrCoulomb::archive(Archive& a) { field_of_known_length(a, "mohr_coulomb/stress_zz", zz_); }

}  // namespace sandgraph::stress

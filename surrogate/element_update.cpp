#include "surrogate/element_update.hpp"

#include <numeric>

#include "base/contracts.hpp"

namespace sandgraph::surrogate {
namespace {

// docs/how_it_works.md (eq. 35):
// p = p_trial + K sum_k D_k dgamma_k with dgamma_k = max(|T_k| - r_k p, 0)/(2 G_k).
double solve_pressure(const Coefficients& c, const std::vector<double>& trial, double p_trial, double p_min) {
    double p = p_trial;
    for (int iteration = 0; iteration < 2; ++iteration) {
        double raised = p_trial, slope = 1;
        for (std::size_t k = 0; k < trial.size(); ++k) {
            if (trial[k] <= c.strength[k] * p) continue;
            const double coupling = c.bulk * c.dilatancy[k] / (2 * c.shear[k]);
            raised += coupling * trial[k];
            slope += coupling * c.strength[k];
        }
        p = std::max(raised / std::max(slope, 0.1), p_min);
    }
    return p;
}

}  // namespace

Deviator MemberState::deviator() const {
    return std::accumulate(elements.begin(), elements.end(), Deviator{});
}

// (eq. 35)
MemberState return_map(const MemberState& state, const Coefficients& c, std::span<const double> share,
                       Deviator de, double dv, double p_min) {
    MemberState next = state;
    const std::size_t M = state.elements.size();
    SG_EXPECT(share.size() == M && c.shear.size() == M && c.strength.size() == M && c.dilatancy.size() == M);
    SG_EXPECT(p_min > 0);
    std::vector<double> trial(M);
    for (std::size_t k = 0; k < M; ++k) {
        next.elements[k] += 2 * c.shear[k] * de;
        trial[k] = std::sqrt(std::norm(next.elements[k]) + 1e-12);  // [Pa]; finite slope at 0
    }
    next.p = solve_pressure(c, trial, std::max(state.p + c.bulk * dv, p_min), p_min);
    for (std::size_t k = 0; k < M; ++k) {
        const double limit = c.strength[k] * next.p;
        next.gamma += share[k] * std::max(trial[k] - limit, 0.0) / (2 * c.shear[k]);
        next.elements[k] *= std::min(1.0, limit / trial[k]);
    }
    SG_ENSURE(!(next.p < p_min) && !(next.gamma < state.gamma));
    return next;
}

}  // namespace sandgraph::surrogate

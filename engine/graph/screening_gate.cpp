#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "graph/acoustic.hpp"
#include "graph/bearable.hpp"
#include "graph/screening_law.hpp"
#include "graph/stress_arithmetic.hpp"

namespace sandgraph::graph {
namespace {

constexpr std::size_t kGateGrain = 256;  // answers a task

constexpr double kAuditFloor = 1000;  // [Pa]

// An answer is absurd when it moves by more than this many times the elastic change and half of p besides.
constexpr double kAbsurdChange = 20, kAbsurdShare = 0.5;

double contract(const Stress& s, const stress::Increment& e) {
    return s.xx * e.xx + s.yy * e.yy + 2 * s.xy * e.xy;
}

bool finite(const stress::SurrogateAnswer& a) {
    return std::isfinite(a.stress.xx) && std::isfinite(a.stress.yy) && std::isfinite(a.stress.xy) &&
           std::isfinite(a.spread) && std::isfinite(a.distance);
}

}  // namespace

void ScreeningLaw::settle_answers(const stress::Batch& batch) {
    verdicts_.resize(asked_.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, asked_.size(), kGateGrain), [&](const auto& range) {
        for (std::size_t slot = range.begin(); slot < range.end(); ++slot) settle_answer(slot, batch);
    });
}

void ScreeningLaw::settle_answer(std::size_t slot, const stress::Batch& batch) {
    const std::int32_t p = asked_[slot];
    const stress::SurrogateAnswer& a = answers_[slot];
    Stress& s = batch.stress[p];
    const double floor = setup_.grains.options.pressure_floor;
    if (visits_.collected(p).allFinite()) F_[p] = visits_.collected(p) * F_[p];
    if (mode_[p] < PointMode::shadow && !caught_up_[p]) paths_[p].add(F_[p]);
    // A jump that fades lies on top of what the surrogate was predicted to answer.
    const Stress predicted = difference(s, blend_[p]);
    if (absurd(a, p, predicted)) {
        verdicts_[slot] = {1, Reason::failed_answer};
        visits_.answered(p, reference_pressure(s, floor), 1, setup_.visits);
        return;
    }
    verdicts_[slot] = judge_answer(slot, predicted);
    const double reference = reference_pressure(a.stress, floor);
    visits_.answered(p, reference, norm(difference(a.stress, predicted)) / reference, setup_.visits);
    s = a.stress;
    if (fade_left_[p] > 0) blend_[p] = bearable(s, blend_[p]), add(s, blend_[p]);
    if (const std::int32_t place = audit_of_[p]; place >= 0) {
        const Stress truth = tension_positive(audit_rves_[place].stress());
        audit_errors_[place] = norm(difference(s, truth)) / reference_pressure(truth, kAuditFloor);
    }
}

bool ScreeningLaw::absurd(const stress::SurrogateAnswer& a, std::int32_t p, const Stress& predicted) const {
    const double allowed = kAbsurdChange * norm(visits_.change(p)) +
                           kAbsurdShare * reference_pressure(predicted, setup_.grains.options.pressure_floor);
    return !finite(a) || norm(difference(a.stress, predicted)) > allowed;
}

Verdict ScreeningLaw::judge_answer(std::size_t slot, const Stress& predicted) const {
    const std::int32_t p = asked_[slot];
    const stress::SurrogateAnswer& a = answers_[slot];
    GateView view{F_[p], a.stress, traits(p).strength, a.spread, a.distance};
    const stress::Increment e = stress::increment(visits_.collected(p));
    const double elastic = contract(visits_.change(p), e);
    if (elastic > 0) view.work = 1 + contract(difference(a.stress, predicted), e) / elastic;
    const double limit = setup_.gate.acoustic_from * view.strength;
    if (setup_.gate.active && view.strength > 0 && deviator(a.stress) > limit * mean_stress(a.stress))
        view.acoustic = acoustic_share(p, e);
    return judge(view, setup_.gate);
}

// Against the elastic det = G (K + G), the same in all directions.
double ScreeningLaw::acoustic_share(std::int32_t p, const stress::Increment& e) const {
    const std::size_t size = setup_.surrogate->state_size();
    const auto state = std::span(states_).subspan(static_cast<std::size_t>(p) * size, size);
    const PlaneModuli& m = row(p).moduli;
    return least_acoustic_determinant(setup_.surrogate->tangent(state, {e.xx, e.yy, 2 * e.xy})) /
           (m.shear * m.p_wave());
}

}  // namespace sandgraph::graph

#include <tbb/parallel_for.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/contracts.hpp"
#include "graph/screening/acoustic.hpp"
#include "graph/screening/law.hpp"
#include "graph/stress_arithmetic.hpp"

// How answers become stresses and points change hands.
namespace sandgraph::graph {
namespace {

constexpr std::size_t kGateGrain = 256;  // answers a task

// An answer is absurd when it moves by more than this many times the elastic change and half of p besides.
constexpr double kAbsurdChange = 20, kAbsurdShare = 0.5;

// Members part more in critical-state shear, as twins of a packing do; a surrogate of noise parts by far
// more.
constexpr double kFlowSpread = 3;  // times the gate's threshold

double contract(const Stress& s, const stress::Increment& e) {
    return s.xx * e.xx + s.yy * e.yy + 2 * s.xy * e.xy;
}

bool finite(const stress::SurrogateAnswer& a) {
    return std::isfinite(a.stress.xx) && std::isfinite(a.stress.yy) && std::isfinite(a.stress.xy) &&
           std::isfinite(a.spread) && std::isfinite(a.distance);
}

// How far predictions of grains by their secant came true tells nothing of the surrogate's, nor the other way
// round: whoever takes over is asked soon. (Elastic ones are alike.)
void start_anew(Visits& visits, std::int32_t point, double reference, const VisitSettings& grains,
                const VisitSettings& next) {
    if (grains.predictor == Predictor::secant) visits.answered(point, reference, 1, next);
}

// A NaN compares as false.
bool usable(const stress::SurrogateAnswer& answer, double largest_spread) {
    return std::isfinite(norm(answer.stress)) && answer.spread <= largest_spread;
}

}  // namespace

// Each stage needs what the ones before it have settled.
void ScreeningLaw::hand_over(const stress::Batch& batch) {
    SG_EXPECT(answers_.size() == asked_.size() && rve_answers_.size() == jobs_.size());
    note_followed_strain();  // of points by grains, whose surrogate goes along
    settle_grains(batch);    // packings' answers become stresses
    fade_jumps(batch);       // blending -> grains
    settle_answers(batch);   // the surrogate's answers become stresses, the gate judges them
    felt_.after(batch.stress, floor(), log_.switches);
    settle_replays();     // replay -> shadow
    raise(batch.around);  // surrogate -> replay, and reasons to hand over
    replace_failed();     // failed answers -> shadow, at once
    switch_ready(batch);  // shadow -> blending
    hand_back(batch);     // grains -> critical state
    audit_load(batch);    // what the stresses as they are now do to the load
    close_step(batch.around.d_over_B);
}

void ScreeningLaw::note_followed_strain() {
    for (const std::int32_t p : followed_)
        if (visits_.collected(p).allFinite()) F_[p] = visits_.collected(p) * F_[p];
}

void ScreeningLaw::settle_grains(const stress::Batch& batch) {
    for (std::size_t slot = 0; slot < jobs_.size(); ++slot) {
        const dem::RveReport& report = rve_answers_[slot].report;
        stress::ScreeningCounters& aside = log_.counters;
        if (jobs_[slot].task == Task::answer) {
            settle_grain_answer(slot, batch);
            continue;
        }
        counters_.failures += failed(report.status);
        (jobs_[slot].task == Task::replay   ? aside.replay_steps
         : jobs_[slot].task == Task::follow ? aside.shadow_steps
                                            : aside.audit_steps) += report.dem_steps;
        if (jobs_[slot].task == Task::replay) caught_up_[jobs_[slot].point] = rve_answers_[slot].caught_up;
    }
}

void ScreeningLaw::settle_grain_answer(std::size_t slot, const stress::Batch& batch) {
    const std::int32_t p = jobs_[slot].point;
    if (rve_answers_[slot].report.unfinished) {
        batch.stress[p] =
            blend_.on_top_of(stress_on_the_way(rve_answers_[slot], visits_, p, setup_.grains), p);
        return counters_.count(rve_answers_[slot].report, false, 0);
    }
    const Stress by_grains = tension_positive(rve_answers_[slot].stress);
    const Stress now = blend_.on_top_of(by_grains, p);
    const double reference = reference_pressure(by_grains, floor());
    const Stress beyond = difference(now, batch.stress[p]);
    const double error = norm(beyond) / reference;
    visits_.learn(p, beyond, setup_.grains.packing(p).moduli, setup_.grains.visits);
    batch.stress[p] = now;
    counters_.count(rve_answers_[slot].report, visits_.answered(p, reference, error, setup_.grains.visits),
                    error);
}

void ScreeningLaw::fade_jumps(const stress::Batch& batch) {
    blend_.fade(batch.F_inc, batch.around.volume, batch.stress, log_.counters.jump_work);
    for (const std::int32_t p : blend_.ended())
        if (modes_.allows(p, ModeEvent::faded)) modes_.apply(p, ModeEvent::faded);
}

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
    if (visits_.collected(p).allFinite()) F_[p] = visits_.collected(p) * F_[p];
    if (modes_[p] < PointMode::shadow && !caught_up_[p]) paths_[p].add(F_[p]);
    // A jump that fades lies on top of what the surrogate was predicted to answer.
    const Stress predicted = difference(s, blend_.rest(p));
    if (absurd(a, p, predicted)) {
        verdicts_[slot] = {1, Reason::failed_answer};
        visits_.answered(p, reference_pressure(s, floor()), 1, setup_.visits);
        return;
    }
    verdicts_[slot] = judge_answer(slot, predicted);
    const double reference = reference_pressure(a.stress, floor());
    visits_.answered(p, reference, norm(difference(a.stress, predicted)) / reference, setup_.visits);
    s = blend_.fading(p) ? blend_.on_top_of(a.stress, p) : a.stress;
    if (const std::int32_t place = audit_.place(p); place >= 0)
        audit_.measure(place, s, tension_positive(pool_->stress(audit_rve(place))));
}

bool ScreeningLaw::absurd(const stress::SurrogateAnswer& a, std::int32_t p, const Stress& predicted) const {
    const double allowed =
        kAbsurdChange * norm(visits_.change(p)) + kAbsurdShare * reference_pressure(predicted, floor());
    return !finite(a) || norm(difference(a.stress, predicted)) > allowed;
}

Verdict ScreeningLaw::judge_answer(std::size_t slot, const Stress& predicted) const {
    const std::int32_t p = asked_[slot];
    const stress::SurrogateAnswer& a = answers_[slot];
    GateView view{F_[p], a.stress, traits(p).peak_friction, a.spread, a.distance};
    const stress::Increment e = stress::increment(visits_.collected(p));
    const double elastic = contract(visits_.change(p), e);
    // docs/how_it_works.md (eq. 39).
    if (elastic > 0) view.work = 1 + contract(difference(a.stress, predicted), e) / elastic;
    const double limit = setup_.gate.acoustic_from * view.peak_friction;
    if (setup_.gate.active && view.peak_friction > 0 && deviator(a.stress) > limit * mean_stress(a.stress))
        view.acoustic = acoustic_share(p, e);
    return judge(view, setup_.gate);
}

// Against the elastic det = G (K + G), the same in all directions.
double ScreeningLaw::acoustic_share(std::int32_t p, const stress::Increment& e) const {
    const PlaneModuli& m = setup_.grains.packing(p).moduli;
    return least_acoustic_determinant(setup_.surrogate->tangent(state(p), {e.xx, e.yy, 2 * e.xy})) /
           (m.shear * m.p_wave());
}

void ScreeningLaw::settle_replays() {
    for (const Job& job : jobs_) {
        if (job.task != Task::replay || !caught_up_[job.point]) continue;
        caught_up_[job.point] = 0;
        modes_.apply(job.point, ModeEvent::caught_up);
        paths_[job.point].clear();
    }
}

// From the low threshold on a packing is made ready, at the high one the point asks to be handed over.
void ScreeningLaw::raise(const Surroundings& around) {
    std::vector<std::int32_t> centres;
    for (std::size_t slot = 0; slot < asked_.size(); ++slot) {
        const auto [level, reason] = verdicts_[slot];
        const std::int32_t p = asked_[slot];
        if (level >= setup_.gate.low && modes_.allows(p, ModeEvent::near_gate))
            modes_.apply(p, ModeEvent::near_gate);
        const Reason before = modes_.reason(p);
        if (level < 1 || before == Reason::failed_answer) continue;
        // A neighbour that passes the gate itself raises its own neighbours; nobody does twice.
        const bool first = before == Reason::none || before == Reason::neighbour;
        if (first) centres.push_back(p);
        if (first || reason == Reason::failed_answer) modes_.set_reason(p, reason);
    }
    if (setup_.hand_over.dilate > 0 && !centres.empty()) raise_neighbours(centres, around);
}

void ScreeningLaw::raise_neighbours(const std::vector<std::int32_t>& centres, const Surroundings& around) {
    if (around.x.empty()) return;
    const double reach = (setup_.hand_over.dilate + 0.5) * around.cell;
    for (const std::int32_t c : centres)
        for (std::size_t p = 0; p < size(); ++p) {
            const bool near = std::abs(around.x[p] - around.x[static_cast<std::size_t>(c)]) <= reach &&
                              std::abs(around.y[p] - around.y[static_cast<std::size_t>(c)]) <= reach;
            if (!near || modes_.by_grains(p) || modes_.reason(p) != Reason::none) continue;
            modes_.set_reason(p, Reason::neighbour);
            if (modes_.allows(p, ModeEvent::near_gate)) modes_.apply(p, ModeEvent::near_gate);
        }
}

// A point whose answer cannot be used keeps the predicted stress for this step; its packing catches up now,
// however long it takes (that of one in critical-state shear goes on from where it went back).
void ScreeningLaw::replace_failed() {
    std::vector<RveJob> lost;
    for (std::size_t slot = 0; slot < asked_.size(); ++slot)
        if (verdicts_[slot].reason == Reason::failed_answer) {
            const auto p = static_cast<std::size_t>(asked_[slot]);
            lost.push_back({.rve = p,
                            .increment = {},
                            .path = &paths_[p],
                            .path_steps = std::numeric_limits<int>::max()});
        }
    if (lost.empty()) return;
    std::vector<RveAnswer> driven(lost.size());
    pool_->drive(lost, driven);
    for (std::size_t k = 0; k < lost.size(); ++k) {
        ++log_.counters.failed_answers;
        log_.counters.replay_steps += driven[k].report.dem_steps;
        counters_.failures += failed(driven[k].report.status);
        modes_.apply(lost[k].rve, ModeEvent::answer_failed);
        paths_[lost[k].rve].clear();
    }
}

// Only points that were asked in this step: there surrogate and packing stand at the same strain.
void ScreeningLaw::switch_ready(const stress::Batch& batch) {
    for (const std::int32_t p : asked_) {
        if (modes_.reason(p) == Reason::none || !modes_.allows(p, ModeEvent::handed_over)) continue;
        const Stress by_grains = tension_positive(pool_->stress(p)),
                     jump = difference(batch.stress[p], by_grains);
        blend_.start(p, jump);
        modes_.apply(p, ModeEvent::handed_over);
        const double reference = reference_pressure(by_grains, floor());
        start_anew(visits_, p, reference, setup_.grains.visits, setup_.grains.visits);
        note({log_.counters.steps, batch.around.d_over_B, p, modes_.reason(p), norm(jump) / reference});
    }
}

// In critical-state shear one packing's stress is weather: twins of it part by more than the surrogate is
// off, and these few points cost most of all DEM steps. Past GateSettings::flow a point goes back to the
// surrogate, which has followed its strain all the while.
void ScreeningLaw::hand_back(const stress::Batch& batch) {
    for (std::size_t slot = 0; slot < followed_.size(); ++slot) {
        const std::int32_t p = followed_[slot];
        if (!goes_back(p, follower_answers_[slot])) continue;
        const Stress jump = difference(batch.stress[p], follower_answers_[slot].stress);
        blend_.start(p, jump);
        modes_.apply(p, ModeEvent::flows);
        const double reference = reference_pressure(batch.stress[p], floor());
        start_anew(visits_, p, reference, setup_.grains.visits, setup_.visits);
        note({log_.counters.steps, batch.around.d_over_B, p, Reason::critical_state, norm(jump) / reference});
        // Its audit goes on with the grains that have answered till now, whose stress it still has.
        if (const std::int32_t place = audit_.place(p); place >= 0)
            pool_->copy(p, audit_rve(place)), audit_.forget(place);
        if (auditors_.present()) auditors_.go_on_from_grains(p, F_[p], state(p));
    }
}

void ScreeningLaw::audit_load(const stress::Batch& batch) {
    if (!auditors_.present()) return;
    const Followed ground{batch, visits_, F_, states_, setup_.traits, setup_.grains, *setup_.surrogate};
    log_.counters.load_audit_steps +=
        auditors_.after_step(ground, asked_, modes_, *pool_, counters_.failures);
    auditors_.add_known(missing_under_jumps(batch));
}

// Where grains answer, a jump that fades is an error that is known [J/m].
double ScreeningLaw::missing_under_jumps(const stress::Batch& batch) const {
    double out = 0;
    for (const std::int32_t point : blend_.points()) {
        const auto p = static_cast<std::size_t>(point);
        const double volume = batch.around.volume.empty() ? 1 : batch.around.volume[p];
        if (modes_.by_grains(p)) out -= volume * product(blend_.rest(p), small_strain(batch.F_inc[p]));
    }
    return out;
}

bool ScreeningLaw::goes_back(std::int32_t p, const stress::SurrogateAnswer& followed) const {
    return modes_.allows(p, ModeEvent::flows) && !pool_->floating(p) &&
           modes_.reason(p) != Reason::failed_answer && deviatoric_strain(F_[p]) >= setup_.gate.flow &&
           usable(followed, kFlowSpread * setup_.gate.spread);
}

void ScreeningLaw::close_step(double d_over_B) {
    SG_ENSURE(modes_.grain_points() <= size());
    ++log_.counters.steps;
    log_.counters.dem_points += static_cast<double>(modes_.grain_points());
    if (!audit_.due(d_over_B)) return;
    audit_now(d_over_B);
    audit_.schedule_after(d_over_B);
}

void ScreeningLaw::note(const stress::Switch& one) {
    log_.switches.push_back(one);
    felt_.watch(log_.switches);
}

}  // namespace sandgraph::graph

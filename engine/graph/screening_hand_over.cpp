#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "graph/screening_law.hpp"
#include "graph/stress_arithmetic.hpp"

namespace sandgraph::graph {

void ScreeningLaw::hand_over(const stress::Batch& batch, const Surroundings& around) {
    for (const std::int32_t p : followed_)
        if (visits_.collected(p).allFinite()) F_[p] = visits_.collected(p) * F_[p];
    settle_grains();
    fade(batch, around);
    settle_answers(batch);
    felt_.after(batch.stress, setup_.grains.options.pressure_floor, switches_);
    settle_replays();
    raise(around);
    replace_failed();
    switch_ready(batch, around.d_over_B);
    if (setup_.gate.flow > 0) hand_back(batch, around.d_over_B);
    ++screening_.steps;
    screening_.dem_points += static_cast<double>(dem_points_);
    if (around.d_over_B < next_audit_) return;
    audit_now(around.d_over_B);
    while (next_audit_ <= around.d_over_B) next_audit_ += setup_.audit.every;
}

void ScreeningLaw::settle_replays() {
    for (const Job& job : jobs_) {
        if (job.task != Task::replay || !caught_up_[job.point]) continue;
        caught_up_[job.point] = 0;
        mode_[job.point] = PointMode::shadow;
        paths_[job.point].clear();
    }
}

// From the low threshold on a packing is made ready, at the high one the point asks to be handed over.
void ScreeningLaw::raise(const Surroundings& around) {
    std::vector<std::int32_t> centres;
    for (std::size_t slot = 0; slot < asked_.size(); ++slot) {
        const auto [level, reason] = verdicts_[slot];
        const std::int32_t p = asked_[slot];
        if (level >= setup_.gate.low && mode_[p] == PointMode::surrogate) mode_[p] = PointMode::replay;
        if (level < 1 || reason_[p] == Reason::failed_answer) continue;
        // A neighbour that passes the gate itself raises its own neighbours; nobody does twice.
        const bool first = reason_[p] == Reason::none || reason_[p] == Reason::neighbour;
        if (first) centres.push_back(p);
        if (first || reason == Reason::failed_answer) reason_[p] = reason;
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
            if (!near || by_grains(p) || reason_[p] != Reason::none) continue;
            reason_[p] = Reason::neighbour;
            if (mode_[p] == PointMode::surrogate) mode_[p] = PointMode::replay;
        }
}

// A point whose answer cannot be used keeps the predicted stress for this step; its packing catches up now
// (that of one which flowed goes on from where it went back).
void ScreeningLaw::replace_failed() {
    std::vector<std::int32_t> lost;
    for (std::size_t slot = 0; slot < asked_.size(); ++slot)
        if (verdicts_[slot].reason == Reason::failed_answer) lost.push_back(asked_[slot]);
    std::vector<dem::RveReport> reports(lost.size());
    tbb::parallel_for(std::size_t{0}, lost.size(),
                      [&](std::size_t k) { reports[k] = drive_to_end(lost[k]); });
    for (std::size_t k = 0; k < lost.size(); ++k) {
        ++screening_.failed_answers;
        screening_.replay_steps += reports[k].dem_steps;
        counters_.failures += failed(reports[k].status);
        mode_[lost[k]] = PointMode::shadow;
        paths_[lost[k]].clear();
    }
}

// Only points that were asked in this step: there surrogate and packing stand at the same strain.
void ScreeningLaw::switch_ready(const stress::Batch& batch, double d_over_B) {
    for (const std::int32_t p : asked_)
        if (mode_[p] == PointMode::shadow && reason_[p] != Reason::none) switch_point(p, batch, d_over_B);
}

void ScreeningLaw::switch_point(std::int32_t p, const stress::Batch& batch, double d_over_B) {
    const Stress now = tension_positive(rves_[p].stress());
    start_fading(p, PointMode::blending, difference(batch.stress[p], now));
    ++dem_points_;
    const double jump = norm(blend_[p]) / reference_pressure(now, setup_.grains.options.pressure_floor);
    note({screening_.steps, d_over_B, p, reason_[p], jump});
}

void ScreeningLaw::note(const Switch& one) {
    switches_.push_back(one);
    felt_.watch(switches_);
}

// A point may be switched again before its last jump is gone; the new one holds what was left of it.
void ScreeningLaw::start_fading(std::int32_t p, PointMode mode, const Stress& jump) {
    if (fade_left_[p] == 0) fading_.push_back(p);
    blend_[p] = jump;
    fade_left_[p] = setup_.hand_over.blend_steps;
    mode_[p] = mode;
}

// sigma = sigma_DEM + w (sigma_surrogate - sigma_DEM at the switch), w: 1 -> 0 in equal steps.
void ScreeningLaw::fade(const stress::Batch& batch, const Surroundings& around) {
    for (const std::int32_t p : fading_) {
        const Mat2& F = batch.F_inc[p];
        Stress& rest = blend_[p];
        const double work = rest.xx * (F(0, 0) - 1) + rest.yy * (F(1, 1) - 1) + rest.xy * (F(0, 1) + F(1, 0));
        if (!around.volume.empty()) screening_.jump_work += work * around.volume[static_cast<std::size_t>(p)];
        const double w = 1.0 / fade_left_[p]--;
        const Stress part = {w * rest.xx, w * rest.yy, w * rest.xy};
        rest = difference(rest, part);
        batch.stress[p] = difference(batch.stress[p], part);
        if (fade_left_[p] == 0 && mode_[p] == PointMode::blending) mode_[p] = PointMode::grains;
    }
    std::erase_if(fading_, [&](std::int32_t p) { return fade_left_[p] == 0; });
}

}  // namespace sandgraph::graph

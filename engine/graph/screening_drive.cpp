#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "graph/bearable.hpp"
#include "graph/screening_law.hpp"
#include "graph/stress_arithmetic.hpp"

namespace sandgraph::graph {
namespace {

constexpr double kLargestPiece = 0.1;  // strain of one update that catches up

}  // namespace

void ScreeningLaw::route(const stress::Batch& batch) {
    asked_.clear(), followed_.clear(), jobs_.clear();
    for (const std::int32_t p : batch.points) {
        if (visits_.due(p))
            add_visit(p);
        else if (mode_[p] == PointMode::replay)
            add_job(p, Task::replay, rves_[p], 0);
    }
    std::stable_sort(jobs_.begin(), jobs_.end(),
                     [](const Job& a, const Job& b) { return a.expected_steps > b.expected_steps; });
}

void ScreeningLaw::add_visit(std::int32_t p) {
    const double strain = strain_norm(visits_.collected(p));
    if (by_grains(p)) {
        if (setup_.gate.flow > 0) followed_.push_back(p);
        return add_job(p, Task::answer, rves_[p], strain);
    }
    asked_.push_back(p);
    if (mode_[p] == PointMode::replay) add_job(p, Task::replay, rves_[p], strain);
    if (mode_[p] == PointMode::shadow) add_job(p, Task::follow, rves_[p], strain);
    if (const std::int32_t place = audit_of_[p]; place >= 0)
        add_job(p, Task::audit, audit_rves_[place], strain);
}

void ScreeningLaw::add_job(std::int32_t point, Task task, const dem::Rve& rve, double strain) {
    const double in_steps =
        rve.floating() ? 0 : strain / rve.strain_per_step(setup_.grains.material, setup_.grains.options);
    const double behind = task == Task::replay ? setup_.hand_over.replay_steps : 0;
    jobs_.push_back({point, task, in_steps + behind});
}

void ScreeningLaw::drive(const stress::Batch& batch) {
    outcomes_.assign(jobs_.size(), {});
    assign_records();
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, jobs_.size(), 1),
        [&](const auto& range) {
            for (std::size_t slot = range.begin(); slot < range.end(); ++slot)
                outcomes_[slot] = run(jobs_[slot], batch), record(slot);
        },
        tbb::simple_partitioner());
}

// What the surrogate reads while the packings are driven is settled after both.
void ScreeningLaw::settle_grains() {
    for (std::size_t slot = 0; slot < jobs_.size(); ++slot) {
        Outcome& out = outcomes_[slot];
        if (jobs_[slot].task == Task::answer)
            out.waited = visits_.answered(jobs_[slot].point, out.reference, out.error, setup_.grains.visits);
        count(jobs_[slot], out);
    }
}

// Records are owned by slot, so that their order hangs on no thread. A point that went to its grains and came
// back has a gap in what its second packing was driven through: its history is over.
void ScreeningLaw::assign_records() {
    record_of_.assign(jobs_.size(), -1);
    std::int32_t count = 0;
    for (std::size_t slot = 0; slot < jobs_.size() && watching_; ++slot)
        if (jobs_[slot].task == Task::audit && mode_[jobs_[slot].point] != PointMode::flow)
            record_of_[slot] = count++;
    watched_.resize(static_cast<std::size_t>(count));
}

void ScreeningLaw::record(std::size_t slot) {
    if (record_of_[slot] < 0) return;
    const std::int32_t p = jobs_[slot].point;
    const dem::Rve& rve = audit_rves_[audit_of_[p]];
    watched_[static_cast<std::size_t>(record_of_[slot])] = {p,
                                                            visits_.collected(p),
                                                            outcomes_[slot].report,
                                                            rve.stress(),
                                                            rve.volume_ratio(),
                                                            dem::observe(rve, setup_.grains.material)};
}

ScreeningLaw::Outcome ScreeningLaw::run(const Job& job, const stress::Batch& batch) {
    const std::int32_t p = job.point;
    switch (job.task) {
        case Task::answer:
            return answer(p, batch);
        case Task::replay:
            return replay(p);
        case Task::follow:
            return {advance(rves_[p], visits_.collected(p))};
        case Task::audit:
            break;
    }
    return {advance(audit_rves_[audit_of_[p]], visits_.collected(p))};
}

dem::RveReport ScreeningLaw::advance(dem::Rve& rve, const Mat2& F_inc) {
    return rve.update(F_inc, setup_.grains.material, setup_.grains.options, workspaces_.local());
}

ScreeningLaw::Outcome ScreeningLaw::answer(std::int32_t p, const stress::Batch& batch) {
    Outcome out{advance(rves_[p], visits_.collected(p))};
    const Stress by_grains = tension_positive(rves_[p].stress());
    Stress now = by_grains;
    if (mode_[p] == PointMode::blending) blend_[p] = bearable(by_grains, blend_[p]);
    add(now, blend_[p]);
    out.reference = reference_pressure(by_grains, setup_.grains.options.pressure_floor);
    out.error = norm(difference(now, batch.stress[p])) / out.reference;
    batch.stress[p] = now;
    return out;
}

// Some way along the recorded path; where that ends, also through what this step's visit brings.
ScreeningLaw::Outcome ScreeningLaw::replay(std::int32_t p) {
    const RveLawSetup& g = setup_.grains;
    StrainPath& path = paths_[p];
    Outcome out;
    const auto go = [&](const Mat2& F_inc) {
        const dem::RveReport r = advance(rves_[p], F_inc);
        out.report.dem_steps += r.dem_steps;
        if (failed(r.status)) out.report.status = r.status;
    };
    while (!path.done() && out.report.dem_steps < setup_.hand_over.replay_steps)
        go(path.advance((setup_.hand_over.replay_steps - out.report.dem_steps) *
                        rves_[p].strain_per_step(g.material, g.options)));
    out.caught_up = path.done();
    if (out.caught_up && visits_.due(p)) go(visits_.collected(p));
    caught_up_[p] = out.caught_up;
    return out;
}

// At once, however long it takes: for a point whose surrogate has failed.
dem::RveReport ScreeningLaw::drive_to_end(std::int32_t p) {
    dem::RveReport sum;
    while (!paths_[p].done()) {
        const dem::RveReport r = advance(rves_[p], paths_[p].advance(kLargestPiece));
        sum.dem_steps += r.dem_steps;
        if (failed(r.status)) sum.status = r.status;
    }
    return sum;
}

void ScreeningLaw::count(const Job& job, const Outcome& outcome) {
    const dem::RveReport& r = outcome.report;
    counters_.failures += failed(r.status);
    switch (job.task) {
        case Task::answer:
            ++counters_.updates;
            counters_.dem_steps += r.dem_steps;
            counters_.predicted += outcome.waited;
            counters_.prediction_error_sum += outcome.waited ? outcome.error : 0;
            counters_.inertial_number_max = std::max(counters_.inertial_number_max, r.inertial_number);
            break;
        case Task::replay:
            screening_.replay_steps += r.dem_steps;
            break;
        case Task::follow:
            screening_.shadow_steps += r.dem_steps;
            break;
        case Task::audit:
            screening_.audit_steps += r.dem_steps;
    }
}

}  // namespace sandgraph::graph

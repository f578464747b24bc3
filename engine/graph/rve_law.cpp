#include "graph/rve_law.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "dem/packing/observe.hpp"
#include "graph/stress_arithmetic.hpp"

namespace sandgraph::graph {
namespace {

constexpr std::size_t kPredictGrain = 1024;  // points a task of the cheap loop

}  // namespace

RveLaw::RveLaw(RveLawSetup setup) : setup_(std::move(setup)), visits_(setup_.row_of_point.size()) {
    rves_.reserve(visits_.size());
    for (const std::int32_t row : setup_.row_of_point)
        rves_.emplace_back(setup_.rows[static_cast<std::size_t>(row)].packing);
}

void RveLaw::initialise(const stress::Batch& batch) {
    for (const std::int32_t p : batch.points) batch.stress[p] = tension_positive(rves_[p].stress());
}

double RveLaw::p_wave_modulus() const {
    double out = 0;
    for (const RowPacking& row : setup_.rows) out = std::max(out, row.moduli.p_wave());
    return out;
}

void RveLaw::update(const stress::Batch& batch) {
    predict(batch);
    route(batch);
    drive(batch);
}

void RveLaw::predict(const stress::Batch& batch) {
    const double floor = setup_.options.pressure_floor;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, batch.points.size(), kPredictGrain),
                      [&](const auto& range) {
                          for (std::size_t k = range.begin(); k < range.end(); ++k) {
                              const std::int32_t p = batch.points[k];
                              const auto row = static_cast<std::size_t>(setup_.row_of_point[p]);
                              visits_.predict(p, setup_.rows[row].moduli, batch.F_inc[p], rves_[p].floating(),
                                              setup_.visits, floor, batch.stress[p]);
                          }
                      });
}

void RveLaw::route(const stress::Batch& batch) {
    due_.clear();
    for (const std::int32_t p : batch.points) {
        if (!visits_.due(p)) continue;
        const double reference = reference_pressure(batch.stress[p], setup_.options.pressure_floor);
        due_.push_back({p, rves_[p].floating() ? 0 : norm(visits_.change(p)) / std::sqrt(reference)});
    }
    std::stable_sort(due_.begin(), due_.end(),
                     [](const Due& a, const Due& b) { return a.expected_steps > b.expected_steps; });
}

void RveLaw::drive(const stress::Batch& batch) {
    reports_.resize(due_.size());
    errors_.resize(due_.size());
    waited_.resize(due_.size());
    assign_records();
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, due_.size(), 1),
        [&](const auto& range) {
            for (std::size_t slot = range.begin(); slot < range.end(); ++slot) drive_point(slot, batch);
        },
        tbb::simple_partitioner());
    for (std::size_t slot = 0; slot < due_.size(); ++slot) {
        const dem::RveReport& r = reports_[slot];
        ++counters_.updates;
        counters_.dem_steps += r.dem_steps;
        counters_.failures += failed(r.status);
        counters_.predicted += waited_[slot];
        counters_.prediction_error_sum += waited_[slot] ? errors_[slot] : 0;
        counters_.inertial_number_max = std::max(counters_.inertial_number_max, r.inertial_number);
    }
}

void RveLaw::drive_point(std::size_t slot, const stress::Batch& batch) {
    const std::int32_t p = due_[slot].point;
    const Mat2& F_inc = visits_.collected(static_cast<std::size_t>(p));
    reports_[slot] = rves_[p].update(F_inc, setup_.material, setup_.options, workspaces_.local());
    if (record_of_[slot] >= 0) record(slot, F_inc);
    const Stress now = tension_positive(rves_[p].stress());
    const double reference = reference_pressure(now, setup_.options.pressure_floor);
    errors_[slot] = norm(difference(now, batch.stress[p])) / reference;
    waited_[slot] = visits_.answered(p, reference, errors_[slot], setup_.visits);
    batch.stress[p] = now;
}

void RveLaw::watch(std::span<const std::int32_t> points) {
    watch_.assign(rves_.size(), 0);
    for (const std::int32_t p : points) watch_[static_cast<std::size_t>(p)] = 1;
}

// Records are owned by slot, so that their order hangs on no thread.
void RveLaw::assign_records() {
    record_of_.assign(due_.size(), -1);
    std::int32_t count = 0;
    for (std::size_t slot = 0; slot < due_.size() && !watch_.empty(); ++slot)
        if (watch_[static_cast<std::size_t>(due_[slot].point)]) record_of_[slot] = count++;
    watched_.resize(static_cast<std::size_t>(count));
}

void RveLaw::record(std::size_t slot, const Mat2& F_inc) {
    const std::int32_t p = due_[slot].point;
    watched_[static_cast<std::size_t>(record_of_[slot])] = {p,
                                                            F_inc,
                                                            reports_[slot],
                                                            rves_[p].stress(),
                                                            rves_[p].volume_ratio(),
                                                            dem::observe(rves_[p], setup_.material)};
}

std::size_t RveLaw::owning() const {
    return static_cast<std::size_t>(
        std::count_if(rves_.begin(), rves_.end(), [](const dem::Rve& r) { return r.owns_packing(); }));
}

double RveLaw::porosity(std::size_t point) const {
    return 1 - (1 - rves_[point].porosity()) / visits_.collected(point).determinant();
}

}  // namespace sandgraph::graph

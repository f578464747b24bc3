#include "graph/rve_law.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "dem/observe.hpp"

namespace sandgraph::graph {
namespace {

constexpr std::size_t kPredictGrain = 1024;  // points a task of the cheap loop

double norm(const Stress& s) { return std::sqrt(s.xx * s.xx + s.yy * s.yy + 2 * s.xy * s.xy); }

void add(Stress& s, const Stress& d) { s.xx += d.xx, s.yy += d.yy, s.xy += d.xy; }

// Turns with the point by the small angle w (Jaumann); exact rotation comes with the next DEM update.
void turn(Stress& s, double w) {
    const double xy = s.xy, difference = s.xx - s.yy;
    s.xx -= 2 * w * xy, s.yy += 2 * w * xy, s.xy += w * difference;
}

}  // namespace

RveLaw::RveLaw(RveLawSetup setup) : setup_(std::move(setup)) {
    const std::size_t n = setup_.row_of_point.size();
    rves_.reserve(n);
    for (const std::int32_t row : setup_.row_of_point)
        rves_.emplace_back(setup_.rows[static_cast<std::size_t>(row)].packing);
    collected_.assign(n, Mat2::Identity());
    change_.resize(n);
    waited_.assign(n, 0);
    allowance_.assign(n, setup_.update_tolerance);
}

void RveLaw::initialise(const stress::Batch& batch) {
    for (const std::int32_t p : batch.points) batch.stress[p] = tension_positive(rves_[p].stress());
}

double RveLaw::p_wave_modulus() const {
    double out = 0;
    for (const RowPacking& row : setup_.rows) out = std::max(out, row.moduli.p_wave());
    return out;
}

double RveLaw::scale(const Stress& s) const {
    return std::max(mean_stress(s), setup_.options.pressure_floor);
}

void RveLaw::update(const stress::Batch& batch) {
    predict(batch);
    route(batch);
    drive(batch);
}

void RveLaw::predict(const stress::Batch& batch) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, batch.points.size(), kPredictGrain),
                      [&](const auto& range) {
                          for (std::size_t k = range.begin(); k < range.end(); ++k) {
                              const std::int32_t p = batch.points[k];
                              predict_point(p, batch.F_inc[p], batch.stress[p]);
                          }
                      });
}

void RveLaw::predict_point(std::int32_t point, const Mat2& F_inc, Stress& s) {
    const PlaneModuli& moduli = setup_.rows[static_cast<std::size_t>(setup_.row_of_point[point])].moduli;
    const Stress d = elastic_change(moduli, F_inc);
    collected_[point] = F_inc * collected_[point];
    add(change_[point], d);
    if (rves_[point].floating()) return;
    turn(s, 0.5 * (F_inc(1, 0) - F_inc(0, 1)));
    add(s, d);
}

void RveLaw::route(const stress::Batch& batch) {
    due_.clear();
    for (const std::int32_t p : batch.points) {
        const double reference = scale(batch.stress[p]), change = norm(change_[p]);
        // Not `change <= tolerance`: a NaN must reach the packing, which refuses it by name.
        if (change < allowance_[p] * reference) {
            waited_[p] = 1;
            continue;
        }
        due_.push_back({p, rves_[p].floating() ? 0 : change / std::sqrt(reference)});
    }
    std::stable_sort(due_.begin(), due_.end(),
                     [](const Due& a, const Due& b) { return a.expected_steps > b.expected_steps; });
}

void RveLaw::drive(const stress::Batch& batch) {
    reports_.resize(due_.size());
    errors_.resize(due_.size());
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
        counters_.failures +=
            r.status == dem::RveStatus::bad_increment || r.status == dem::RveStatus::diverged;
        std::uint8_t& waited = waited_[due_[slot].point];
        counters_.predicted += waited;
        counters_.prediction_error_sum += waited ? errors_[slot] : 0;
        waited = 0;
        counters_.inertial_number_max = std::max(counters_.inertial_number_max, r.inertial_number);
    }
}

// Step-size control as for an ODE: the prediction's error grows about with the square of the change.
double RveLaw::next_allowance(double change, double error) const {
    const double factor =
        std::clamp(0.9 * std::sqrt(setup_.update_tolerance / std::max(error, 1e-12)), 0.25, 2.0);
    return std::clamp(change * factor, 0.5 * setup_.update_tolerance, setup_.update_change_max);
}

void RveLaw::drive_point(std::size_t slot, const stress::Batch& batch) {
    const std::int32_t p = due_[slot].point;
    reports_[slot] = rves_[p].update(collected_[p], setup_.material, setup_.options, workspaces_.local());
    if (record_of_[slot] >= 0) record(slot, collected_[p]);
    const Stress predicted = batch.stress[p], now = tension_positive(rves_[p].stress());
    const double reference = scale(now), change = norm(change_[p]) / reference;
    errors_[slot] = norm({now.xx - predicted.xx, now.yy - predicted.yy, now.xy - predicted.xy}) / reference;
    allowance_[p] = next_allowance(change, errors_[slot]);
    batch.stress[p] = now;
    collected_[p].setIdentity();
    change_[p] = {};
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
    return 1 - (1 - rves_[point].porosity()) / collected_[point].determinant();
}

}  // namespace sandgraph::graph

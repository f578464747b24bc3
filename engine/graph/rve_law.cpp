#include "graph/rve_law.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "base/byte_stream.hpp"
#include "base/contracts.hpp"
#include "graph/stress_arithmetic.hpp"

namespace sandgraph::graph {
namespace {

using stress::Data, stress::Stage;

constexpr std::size_t kPredictGrain = 1024, kSettleGrain = 64;  // points a task of the cheap loops

}  // namespace

double RveLawSetup::p_wave_modulus() const {
    double out = 0;
    for (const RowPacking& one : packings) out = std::max(out, one.moduli.p_wave());
    return out;
}

InitialPackings RveLawSetup::initial_packings() const {
    InitialPackings out;
    for (std::size_t p = 0; p < packing_of_point.size(); ++p) out.push_back(packing(p).packing);
    return out;
}

void RveCounters::count(const dem::RveReport& report, bool waited, double error) {
    ++updates;
    dem_steps += report.dem_steps;
    failures += failed(report.status);
    predicted += waited;
    prediction_error_sum += waited ? error : 0;
    inertial_number_max = std::max(inertial_number_max, report.inertial_number);
}

dem::RveUpdate update_of(std::int32_t point, const RveJob& job, const RveAnswer& answer) {
    SG_EXPECT(job.increment && answer.seen);
    return {point, *job.increment, answer.report, answer.stress, answer.volume_ratio, *answer.seen};
}

RveLaw::RveLaw(RveLawSetup setup)
    : setup_(std::move(setup)),
      visits_(setup_.packing_of_point.size()),
      pool_(setup_.make_pool(setup_.initial_packings(), setup_.material, setup_.options)) {
    SG_ENSURE(pool_->size() == visits_.size());
}

void RveLaw::initialise(const stress::Batch& batch) {
    for (const std::int32_t p : batch.points) batch.stress[p] = tension_positive(pool_->stress(p));
}

std::vector<Stage> RveLaw::stages() {
    return {{"predict",
             {{Data::increments, 1}, {Data::stress, 0}, {Data::visits, 0}, {Data::packings, 0}},
             {{Data::visits, 1}, {Data::stress, 1}},
             [this](const stress::Batch& batch) { predict(batch); }},
            {"route",
             {{Data::visits, 1}, {Data::stress, 1}, {Data::packings, 0}},
             {{Data::due, 1}},
             [this](const stress::Batch& batch) { route(batch); }},
            {"grains",
             {{Data::due, 1}, {Data::visits, 1}, {Data::stress, 1}, {Data::packings, 0}},
             {{Data::packings, 1}, {Data::stress, 2}, {Data::visits, 2}},
             [this](const stress::Batch& batch) { drive(batch); }}};
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
                              visits_.predict(p, setup_.packing(p).moduli, batch.F_inc[p], pool_->floating(p),
                                              setup_.visits, floor, batch.stress[p]);
                          }
                      });
}

void RveLaw::route(const stress::Batch& batch) {
    due_.clear();
    for (const std::int32_t p : batch.points) {
        if (!visits_.due(p)) continue;
        const double reference = reference_pressure(batch.stress[p], setup_.options.pressure_floor);
        due_.push_back({p, pool_->floating(p) ? 0 : norm(visits_.change(p)) / std::sqrt(reference)});
    }
    std::stable_sort(due_.begin(), due_.end(),
                     [](const Due& a, const Due& b) { return a.expected_steps > b.expected_steps; });
}

void RveLaw::drive(const stress::Batch& batch) {
    jobs_.clear();
    for (const Due& due : due_) {
        const auto p = static_cast<std::size_t>(due.point);
        jobs_.push_back({.rve = p,
                         .increment = visits_.collected(p),
                         .observed = !watched_.empty() && watched_[p] != 0,
                         .may_wait = true});
    }
    answers_.resize(jobs_.size()), predictions_.resize(jobs_.size());
    pool_->drive(jobs_, answers_);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, jobs_.size(), kSettleGrain), [&](const auto& range) {
        for (std::size_t slot = range.begin(); slot < range.end(); ++slot) settle(slot, batch);
    });
    for (std::size_t slot = 0; slot < jobs_.size(); ++slot)
        counters_.count(answers_[slot].report, predictions_[slot].waited, predictions_[slot].error);
}

Stress stress_on_the_way(const RveAnswer& answer, Visits& visits, std::int32_t point,
                         const RveLawSetup& setup) {
    const Mat2& e = answer.to_follow;
    Stress s = tension_positive(answer.stress);
    add(s, visits.carry(point, {e(0, 0), e(1, 1), e(0, 1)}, setup.packing(point).moduli,
                        reference_pressure(s, setup.options.pressure_floor), setup.visits));
    return s;
}

void RveLaw::settle(std::size_t slot, const stress::Batch& batch) {
    const std::int32_t p = due_[slot].point;
    SG_EXPECT(visits_.due(p));
    predictions_[slot] = {};
    if (answers_[slot].report.unfinished) {
        batch.stress[p] = stress_on_the_way(answers_[slot], visits_, p, setup_);
        return;
    }
    const Stress now = tension_positive(answers_[slot].stress);
    const double reference = reference_pressure(now, setup_.options.pressure_floor);
    const Stress beyond = difference(now, batch.stress[p]);
    const double error = norm(beyond) / reference;
    visits_.learn(p, beyond, setup_.packing(p).moduli, setup_.visits);
    predictions_[slot] = {error, visits_.answered(p, reference, error, setup_.visits)};
    batch.stress[p] = now;
}

stress::Observation RveLaw::observe(std::size_t point) const {
    stress::Observation out;
    out.packing = &pool_->rve(point), out.by_grains = true;
    // Deformation since the last DEM update is not in the packing yet; this includes it.
    out.porosity = 1 - (1 - pool_->porosity(point)) / visits_.collected(point).determinant();
    return out;
}

stress::GrainUse RveLaw::grain_use() const {
    return {static_cast<std::int64_t>(owning()), counters_.dem_steps, counters_.updates, counters_.failures};
}

std::vector<std::pair<std::string, double>> RveLaw::figures() const {
    return {{"rve_failures", static_cast<double>(counters_.failures)},
            {"rve_owning_final", static_cast<double>(owning())},
            {"prediction_error_mean",
             counters_.prediction_error_sum / std::max<double>(1, static_cast<double>(counters_.predicted))},
            {"inertial_number_max", counters_.inertial_number_max}};
}

std::vector<std::int32_t> RveLaw::watch(std::span<const std::int32_t> points) {
    watched_.assign(pool_->size(), 0);
    for (const std::int32_t p : points) watched_[static_cast<std::size_t>(p)] = 1;
    return {points.begin(), points.end()};
}

// By slot, so that their order hangs on no thread.
void RveLaw::each_watched_update(const std::function<void(const dem::RveUpdate&)>& tell) const {
    for (std::size_t slot = 0; slot < jobs_.size(); ++slot)
        if (jobs_[slot].observed) tell(update_of(due_[slot].point, jobs_[slot], answers_[slot]));
}

void confirm_packings(Archive& a, const std::vector<RowPacking>& packings) {
    std::vector<std::int64_t> hashes;
    for (const RowPacking& one : packings) hashes.push_back(dem::content_hash(*one.packing));
    std::vector<std::int64_t> read = hashes;
    a.field("initial_packings", read);
    require_state(read == hashes, "initial packings");
}

void RveLaw::archive(Archive& a) {
    confirm_packings(a, setup_.packings);
    std::vector<std::uint8_t> bytes;
    if (!a.reading()) {
        ByteWriter out(bytes);
        out.put(counters_);
        visits_.save(out);
        pool_->save(out);
    }
    a.field("rve", bytes);
    if (!a.reading()) return;
    ByteReader in(bytes);
    in.take(counters_);
    visits_.load(in);
    pool_->load(in);
    require_state(in.empty(), "lengths");
}

}  // namespace sandgraph::graph

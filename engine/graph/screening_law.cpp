#include "graph/screening_law.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/LU>
#include <algorithm>
#include <limits>

#include "graph/stress_arithmetic.hpp"

namespace sandgraph::graph {
namespace {

constexpr std::size_t kPredictGrain = 1024;  // points a task of the cheap loop
constexpr std::size_t kAskGrain = 64;        // points a task of the surrogate

// The path's tolerance as a strain: what changes the stress elastically by `share` of p.
double path_tolerance(const stress::PackingTraits& traits, double share) {
    return share * traits.pressure / (2 * traits.shear);
}

}  // namespace

ScreeningLaw::ScreeningLaw(ScreeningSetup setup)
    : setup_(std::move(setup)),
      visits_(setup_.grains.row_of_point.size()),
      felt_(visits_.size(), setup_.hand_over.blend_steps) {
    const std::size_t n = visits_.size();
    const bool all_grains = setup_.gate.active && setup_.gate.strain <= 0;
    if (all_grains) setup_.gate.flow = 0;
    mode_.assign(n, all_grains ? PointMode::grains : PointMode::surrogate);
    dem_points_ = all_grains ? n : 0;
    reason_.assign(n, Reason::none);
    F_.assign(n, Mat2::Identity());
    states_.resize(n * setup_.surrogate->state_size());
    blend_.resize(n), fade_left_.assign(n, 0), caught_up_.assign(n, 0);
    for (std::size_t p = 0; p < n; ++p) {
        const auto point = static_cast<std::int32_t>(p);
        rves_.emplace_back(row(point).packing);
        paths_.emplace_back(path_tolerance(traits(point), setup_.hand_over.path_error));
    }
    audited_ = draw_sample(n, setup_.audit);
    audit_of_.assign(n, -1);
    audit_errors_.assign(audited_.size(), 0);
    for (std::size_t k = 0; k < audited_.size(); ++k) {
        audit_of_[static_cast<std::size_t>(audited_[k])] = static_cast<std::int32_t>(k);
        audit_rves_.emplace_back(row(audited_[k]).packing);
    }
}

void ScreeningLaw::initialise(const stress::Batch& batch) {
    const std::size_t size = setup_.surrogate->state_size();
    for (const std::int32_t p : batch.points) {
        batch.stress[p] = tension_positive(rves_[p].stress());
        setup_.surrogate->start(traits(p), batch.stress[p], std::span(states_).subspan(p * size, size));
    }
}

double ScreeningLaw::p_wave_modulus() const {
    double out = 0;
    for (const RowPacking& r : setup_.grains.rows) out = std::max(out, r.moduli.p_wave());
    return out;
}

void ScreeningLaw::update(const stress::Batch& batch) {
    predict(batch);
    route(batch);
    ask(batch);
    drive(batch);
    hand_over(batch, {});
}

void ScreeningLaw::predict(const stress::Batch& batch) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, batch.points.size(), kPredictGrain),
                      [&](const auto& range) {
                          for (std::size_t k = range.begin(); k < range.end(); ++k)
                              predict_point(batch.points[k], batch);
                      });
}

void ScreeningLaw::predict_point(std::int32_t point, const stress::Batch& batch) {
    const bool grains = by_grains(static_cast<std::size_t>(point));
    const Mat2& F_inc = batch.F_inc[point];
    felt_.before(point, batch.stress[point]);
    visits_.predict(point, row(point).moduli, F_inc, grains && rves_[point].floating(),
                    grains ? setup_.grains.visits : setup_.visits, setup_.grains.options.pressure_floor,
                    batch.stress[point]);
    if (fade_left_[point] > 0) turn(blend_[point], F_inc);
}

void ScreeningLaw::ask(const stress::Batch&) {
    ask(asked_, answers_);
    ask(followed_, follower_answers_);
}

void ScreeningLaw::ask(const std::vector<std::int32_t>& points,
                       std::vector<stress::SurrogateAnswer>& answers) {
    answers.resize(points.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size(), kAskGrain), [&](const auto& range) {
        setup_.surrogate->update(std::span(points).subspan(range.begin(), range.size()), visits_.collected(),
                                 states_, std::span(answers).subspan(range.begin(), range.size()));
    });
    screening_.surrogate_updates += static_cast<std::int64_t>(points.size());
}

const RowPacking& ScreeningLaw::row(std::int32_t point) const {
    return setup_.grains.rows[static_cast<std::size_t>(setup_.grains.row_of_point[point])];
}

const stress::PackingTraits& ScreeningLaw::traits(std::int32_t point) const {
    return setup_.traits[static_cast<std::size_t>(setup_.grains.row_of_point[point])];
}

std::int64_t ScreeningLaw::dem_steps() const {
    const ScreeningCounters& s = screening_;
    return counters_.dem_steps + s.replay_steps + s.shadow_steps + s.audit_steps;
}

double ScreeningLaw::porosity(std::size_t point) const {
    const double J = visits_.collected(point).determinant();
    if (by_grains(point)) return 1 - (1 - rves_[point].porosity()) / J;
    return 1 - (1 - traits(static_cast<std::int32_t>(point)).porosity) / (J * F_[point].determinant());
}

const dem::Rve* ScreeningLaw::packing(std::size_t point) const {
    if (by_grains(point)) return &rves_[point];
    const std::int32_t place = audit_of_[point];
    return place >= 0 ? &audit_rves_[static_cast<std::size_t>(place)] : nullptr;
}

AuditRow ScreeningLaw::audit() const {
    std::vector<double> sample;
    for (std::size_t k = 0; k < audited_.size(); ++k)
        if (!by_grains(static_cast<std::size_t>(audited_[k]))) sample.push_back(audit_errors_[k]);
    return estimate(sample, size() - dem_points_);
}

void ScreeningLaw::audit_now(double d_over_B) {
    audits_.push_back(audit());
    audits_.back().d_over_B = d_over_B;
}

double ScreeningLaw::audited_error(std::size_t point) const {
    const std::int32_t place = audit_of_[point];
    if (place < 0 || by_grains(point)) return std::numeric_limits<double>::quiet_NaN();
    return audit_errors_[static_cast<std::size_t>(place)];
}

}  // namespace sandgraph::graph

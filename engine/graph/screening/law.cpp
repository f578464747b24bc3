#include "graph/screening/law.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>

#include "base/contracts.hpp"
#include "graph/stress_arithmetic.hpp"

namespace sandgraph::graph {
namespace {

using stress::Data, stress::Stage;

constexpr std::size_t kPredictGrain = 1024;  // points a task of the cheap loop
constexpr std::size_t kAskGrain = 64;        // points a task of the surrogate

// The path's tolerance as a strain: what changes the stress elastically by `share` of p.
double path_tolerance(const stress::PackingTraits& traits, double share) {
    return share * traits.pressure / (2 * traits.shear);
}

bool all_grains(const GateSettings& gate) { return gate.active && gate.strain <= 0; }

ScreeningSetup completed(ScreeningSetup setup) {
    if (all_grains(setup.gate)) setup.gate.flow = 0;
    return setup;
}

// The packings of all points, then the second ones of the audited points, then those of auditors.
std::unique_ptr<RvePool> pool_of(const RveLawSetup& grains, const AuditSample& audit, bool auditors) {
    const auto own = grains.initial_packings();
    auto initial = own;
    for (const std::int32_t p : audit.points()) initial.push_back(own[static_cast<std::size_t>(p)]);
    if (auditors) initial.insert(initial.end(), own.begin(), own.end());
    return grains.make_pool(initial, grains.material, grains.options);
}

Auditors auditors_of(const ScreeningSetup& s, std::size_t first_rve) {
    std::vector<double> tolerance;
    if (s.audit.load_points > 0)
        for (const std::int32_t row : s.grains.packing_of_point)
            tolerance.push_back(
                path_tolerance(s.traits[static_cast<std::size_t>(row)], s.hand_over.path_error));
    const std::size_t points = tolerance.size();
    return {points, s.audit,
            LedPackings(tolerance, s.surrogate->state_size(), first_rve, s.hand_over.replay_steps)};
}

}  // namespace

ScreeningLaw::ScreeningLaw(ScreeningSetup setup)
    : setup_(completed(std::move(setup))),
      visits_(setup_.grains.packing_of_point.size()),
      modes_(visits_.size(), all_grains(setup_.gate) ? PointMode::grains : PointMode::surrogate),
      blend_(visits_.size(), setup_.hand_over.blend_steps),
      audit_(visits_.size(), setup_.audit),
      felt_(visits_.size(), setup_.hand_over.blend_steps),
      pool_(pool_of(setup_.grains, audit_, setup_.audit.load_points > 0)),
      auditors_(auditors_of(setup_, size() + audit_.size())),
      F_(visits_.size(), Mat2::Identity()),
      states_(visits_.size() * setup_.surrogate->state_size()),
      caught_up_(visits_.size(), 0) {
    SG_EXPECT(setup_.traits.size() == setup_.grains.packings.size());
    SG_ENSURE(pool_->size() == (auditors_.present() ? 2 : 1) * size() + audit_.size());
    for (std::size_t p = 0; p < size(); ++p)
        paths_.emplace_back(path_tolerance(traits(p), setup_.hand_over.path_error));
}

void ScreeningLaw::initialise(const stress::Batch& batch) {
    const std::size_t size = setup_.surrogate->state_size();
    for (const std::int32_t p : batch.points) {
        batch.stress[p] = tension_positive(pool_->stress(p));
        setup_.surrogate->start(traits(p), batch.stress[p], std::span(states_).subspan(p * size, size));
    }
}

std::vector<Stage> ScreeningLaw::stages() {
    return {
        {"predict",
         {{Data::increments, 1}, {Data::stress, 0}, {Data::visits, 0}, {Data::packings, 0}, {Data::law, 0}},
         {{Data::visits, 1}, {Data::stress, 1}, {Data::law, 1}},
         [this](const stress::Batch& batch) { predict(batch); }},
        {"route",
         {{Data::visits, 1}, {Data::law, 1}, {Data::packings, 0}},
         {{Data::due, 1}},
         [this](const stress::Batch& batch) { route(batch); }},
        {"surrogate",
         {{Data::due, 1}, {Data::visits, 1}},
         {{Data::answers, 1}},
         [this](const stress::Batch&) { ask(); }},
        {"grains",
         {{Data::due, 1}, {Data::visits, 1}, {Data::law, 1}, {Data::packings, 0}},
         {{Data::packings, 1}},
         [this](const stress::Batch&) { drive(); }},
        {"hand-over",
         {{Data::answers, 1},
          {Data::packings, 1},
          {Data::due, 1},
          {Data::visits, 1},
          {Data::law, 1},
          {Data::stress, 1},
          {Data::increments, 1},
          {Data::points, 1}},
         {{Data::stress, 2}, {Data::visits, 2}, {Data::law, 2}, {Data::packings, 2}},
         [this](const stress::Batch& batch) { hand_over(batch); }}};
}

void ScreeningLaw::update(const stress::Batch& batch) {
    predict(batch);
    route(batch);
    ask();
    drive();
    hand_over(batch);
}

void ScreeningLaw::predict(const stress::Batch& batch) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, batch.points.size(), kPredictGrain),
                      [&](const auto& range) {
                          for (std::size_t k = range.begin(); k < range.end(); ++k)
                              predict_point(batch.points[k], batch);
                      });
}

void ScreeningLaw::predict_point(std::int32_t point, const stress::Batch& batch) {
    const auto p = static_cast<std::size_t>(point);
    const bool grains = modes_.by_grains(p);
    const Mat2& F_inc = batch.F_inc[p];
    felt_.before(point, batch.stress[p]);
    visits_.predict(point, setup_.grains.packing(p).moduli, F_inc, grains && pool_->floating(p),
                    grains ? setup_.grains.visits : setup_.visits, floor(), batch.stress[p]);
    blend_.turn(point, F_inc);
}

void ScreeningLaw::route(const stress::Batch& batch) {
    asked_.clear(), followed_.clear(), jobs_.clear();
    for (const std::int32_t p : batch.points) {
        if (visits_.due(p))
            add_visit(p);
        else if (modes_[p] == PointMode::replay)
            add_job(p, Task::replay, p, 0);
    }
    std::stable_sort(jobs_.begin(), jobs_.end(),
                     [](const Job& a, const Job& b) { return a.expected_steps > b.expected_steps; });
}

void ScreeningLaw::add_visit(std::int32_t p) {
    const double strain = strain_norm(visits_.collected(p));
    if (modes_.by_grains(p)) {
        if (setup_.gate.flow > 0) followed_.push_back(p);
        return add_job(p, Task::answer, p, strain);
    }
    asked_.push_back(p);
    if (modes_[p] == PointMode::replay) add_job(p, Task::replay, p, strain);
    if (modes_[p] == PointMode::shadow) add_job(p, Task::follow, p, strain);
    if (const std::int32_t place = audit_.place(p); place >= 0)
        add_job(p, Task::audit, audit_rve(place), strain);
}

void ScreeningLaw::add_job(std::int32_t point, Task task, std::size_t rve, double strain) {
    const double in_steps = pool_->floating(rve) ? 0 : strain / pool_->strain_per_step(rve);
    const double behind = task == Task::replay ? setup_.hand_over.replay_steps : 0;
    jobs_.push_back({point, task, in_steps + behind});
}

void ScreeningLaw::ask() {
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
    log_.counters.surrogate_updates += static_cast<std::int64_t>(points.size());
}

void ScreeningLaw::drive() {
    rve_jobs_.clear();
    for (const Job& job : jobs_) rve_jobs_.push_back(rve_job(job));
    rve_answers_.resize(jobs_.size());
    pool_->drive(rve_jobs_, rve_answers_);
}

// A point that went to its grains and came back has a gap in what its second packing was driven through: its
// history is over.
RveJob ScreeningLaw::rve_job(const Job& job) {
    const auto p = static_cast<std::size_t>(job.point);
    RveJob out;
    out.rve = p;
    if (visits_.due(job.point)) out.increment = visits_.collected(p);
    out.may_wait = job.task == Task::answer;  // the others are compared at the strain that they were given
    if (job.task == Task::replay) out.path = &paths_[p], out.path_steps = setup_.hand_over.replay_steps;
    if (job.task == Task::audit) {
        out.rve = audit_rve(audit_.place(p));
        out.observed = watching_ && modes_[p] != PointMode::critical_state;
    }
    return out;
}

const stress::PackingTraits& ScreeningLaw::traits(std::size_t point) const {
    return setup_.traits[static_cast<std::size_t>(setup_.grains.packing_of_point[point])];
}

stress::Observation ScreeningLaw::observe(std::size_t point) const {
    stress::Observation out;
    out.by_grains = modes_.by_grains(point), out.mode = static_cast<std::uint8_t>(modes_[point]);
    const std::int32_t place = audit_.place(point);
    const double J = visits_.collected(point).determinant();
    if (out.by_grains) {
        out.packing = &pool_->rve(point);
        out.porosity = 1 - (1 - pool_->porosity(point)) / J;
        return out;
    }
    out.porosity = 1 - (1 - traits(point).porosity) / (J * F_[point].determinant());
    if (place >= 0) out.packing = &pool_->rve(audit_rve(place)), out.audited_error = audit_.error(place);
    return out;
}

stress::GrainUse ScreeningLaw::grain_use() const {
    const stress::ScreeningCounters& s = log_.counters;
    return {static_cast<std::int64_t>(modes_.grain_points()),
            counters_.dem_steps + s.replay_steps + s.shadow_steps + s.audit_steps + s.load_audit_steps,
            counters_.updates, counters_.failures};
}

AuditRow ScreeningLaw::audit() const {
    return audit_.now(size() - modes_.grain_points(), [&](std::int32_t p) { return !modes_.by_grains(p); });
}

void ScreeningLaw::audit_now(double d_over_B) {
    AuditRow row = audit();
    if (row.points == 0) return;  // grains answer for the whole sample: nothing to tell
    row.d_over_B = d_over_B;
    log_.audits.push_back(row);
}

std::vector<std::int32_t> ScreeningLaw::watch(std::span<const std::int32_t>) {
    watching_ = true;
    return audit_.points();
}

// By slot, so that their order hangs on no thread.
void ScreeningLaw::each_watched_update(const std::function<void(const dem::RveUpdate&)>& tell) const {
    for (std::size_t slot = 0; slot < rve_jobs_.size(); ++slot)
        if (rve_jobs_[slot].observed) tell(update_of(jobs_[slot].point, rve_jobs_[slot], rve_answers_[slot]));
}

void ScreeningLaw::archive(Archive& a) {
    confirm_packings(a, setup_.grains.packings);
    std::vector<std::uint8_t> bytes;
    if (!a.reading()) {
        ByteWriter out(bytes);
        save(out);
    }
    a.field("screening", bytes);
    if (!a.reading()) return;
    ByteReader in(bytes);
    load(in);
}

void ScreeningLaw::save(ByteWriter& out) const {
    visits_.save(out), modes_.save(out), blend_.save(out), audit_.save(out);
    out.put(states_);
    for (std::size_t p = 0; p < size(); ++p) {
        out.put(std::span<const double>(F_[p].data(), 4));
        paths_[p].save(out);
    }
    pool_->save(out);
    out.put(log_.audits), out.put(log_.switches), out.put(log_.counters), out.put(counters_);
    felt_.save(out), auditors_.save(out);
}

void ScreeningLaw::load(ByteReader& in) {
    visits_.load(in), modes_.load(in), blend_.load(in), audit_.load(in);
    in.take_same(states_);
    for (std::size_t p = 0; p < size(); ++p) {
        in.take(std::span<double>(F_[p].data(), 4));
        paths_[p].load(in);
    }
    pool_->load(in);
    in.take(log_.audits), in.take(log_.switches), in.take(log_.counters), in.take(counters_);
    felt_.load(in, log_.switches.size()), auditors_.load(in);
    require_state(in.empty(), "lengths");
    require_sound();
}

void ScreeningLaw::require_sound() const {
    for (const stress::Switch& s : log_.switches) {
        require_state(static_cast<std::size_t>(s.reason) < stress::reason_count, "switches");
        require_indices(std::array{s.point}, size(), "switches");
    }
}

}  // namespace sandgraph::graph

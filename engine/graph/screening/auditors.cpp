#include "graph/screening/auditors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/contracts.hpp"
#include "graph/screening/power_draw.hpp"
#include "graph/stress_arithmetic.hpp"

namespace sandgraph::graph {
namespace {

constexpr double kMemory = 0.9;  // of the ratio of missing work, at each row
constexpr double kFade = 0.5;    // of the power noted so far, at each draw: mechanisms move

// A mechanism forms early: draws are close at first.
constexpr double kFirst = 0.05, kGrowth = 0.3;  // of AuditSettings::every; of d/B

double sum(const std::vector<double>& v) { return std::accumulate(v.begin(), v.end(), 0.0); }

double volume_of(const stress::Batch& batch, std::size_t p) {
    return batch.around.volume.empty() ? 1 : batch.around.volume[p];
}

// Size of a small strain, from F to F.
double strain_between(const Mat2& a, const Mat2& b) {
    const Mat2 d = b - a;
    return std::sqrt(d(0, 0) * d(0, 0) + d(1, 1) * d(1, 1) + 0.5 * (d(0, 1) + d(1, 0)) * (d(0, 1) + d(1, 0)));
}

}  // namespace

Auditors::Auditors(std::size_t points, const AuditSettings& settings, LedPackings packings)
    : settings_(settings),
      packings_(std::move(packings)),
      number_(permanent_numbers(points, settings.seed)),
      power_(points, 0),
      missing_(points, 0),
      missing_spread_(points, 0),
      moved_(points, 0),
      moved_spread_(points, 0),
      moved_now_(points, 0) {}

std::int64_t Auditors::after_step(const Followed& ground, std::span<const std::int32_t> asked,
                                  const Modes& modes, RvePool& pool, std::int64_t& failures) {
    if (!present()) return 0;
    record(ground, asked, modes);
    leave_to_grains(modes);
    if (!making_ready_ && ground.batch.around.d_over_B >= next_draw_) draw(ground, modes, pool);
    std::vector<std::int32_t> points;
    for (const Auditor& a : auditors_) points.push_back(a.point);
    const std::int64_t steps = packings_.follow(points, ground, pool, failures);
    take_over(ground);
    for (const Auditor& a : auditors_)
        if (a.chance > 0) count(a, ground.batch);
    forget_step(asked);
    return steps;
}

void Auditors::record(const Followed& ground, std::span<const std::int32_t> asked, const Modes& modes) {
    for (const std::int32_t point : asked) {
        const auto p = std::size_t(point);
        if (modes.by_grains(p) || !ground.F[p].allFinite()) continue;
        const double pressure = std::fmax(0, mean_stress(ground.batch.stress[p]));
        moved_now_[p] =
            volume_of(ground.batch, p) * pressure * strain_between(packings_.recorded(point), ground.F[p]);
        power_[p] += moved_now_[p], moved_by_all_ += moved_now_[p];
        packings_.record(point, ground.F[p]);
    }
}

// Their errors are over.
void Auditors::leave_to_grains(const Modes& modes) {
    std::erase_if(auditors_, [&](const Auditor& a) { return modes.by_grains(std::size_t(a.point)); });
}

void Auditors::draw(const Followed& ground, const Modes& modes, RvePool& pool) {
    std::vector<double> size = power_;
    for (std::size_t p = 0; p < size.size(); ++p)
        if (modes.by_grains(p)) size[p] = -1;
    enlist(chances(size, settings_.load_points, settings_.load_evenly), pool);
    for (double& power : power_) power *= kFade;
    making_ready_ = true;
    const double d = ground.batch.around.d_over_B;
    next_draw_ = d + std::clamp(kGrowth * d, kFirst * settings_.every, settings_.every);
}

// docs/how_it_works.md (eq. 41c).
void Auditors::enlist(const std::vector<double>& chance, RvePool& pool) {
    std::vector<Auditor> all;
    auto old = auditors_.begin();
    for (std::size_t p = 0; p < chance.size(); ++p) {
        const bool drawn = number_[p] < chance[p];
        const bool held = old != auditors_.end() && std::size_t(old->point) == p;
        if (drawn || held) all.push_back({std::int32_t(p), held ? old->chance : 0, drawn ? chance[p] : 0});
        if (drawn && !held) packings_.call(std::int32_t(p), pool);
        if (held) ++old;
    }
    auditors_ = std::move(all);
}

void Auditors::take_over(const Followed& ground) {
    const auto ready = [&](const Auditor& a) { return a.next == 0 || packings_.level(a.point); };
    if (!making_ready_ || !std::ranges::all_of(auditors_, ready)) return;
    making_ready_ = false;
    for (Auditor& a : auditors_) {
        a.chance = a.next;
        if (a.chance == 0) packings_.dismiss(a.point, ground.state(a.point));
    }
    std::erase_if(auditors_, [](const Auditor& a) { return a.chance == 0; });
}

// docs/how_it_works.md (eq. 41d).
void Auditors::count(const Auditor& a, const stress::Batch& batch) {
    const auto p = std::size_t(a.point);
    Stress& shortfall = packings_.shortfall(a.point);
    turn(shortfall, batch.F_inc[p]);
    const double missing = volume_of(batch, p) * product(shortfall, small_strain(batch.F_inc[p]));
    const double spread = std::sqrt(1 - a.chance) / a.chance;
    missing_[p] += missing / a.chance, missing_spread_[p] += spread * missing;
    moved_[p] += moved_now_[p] / a.chance, moved_spread_[p] += spread * moved_now_[p];
}

void Auditors::forget_step(std::span<const std::int32_t> asked) {
    for (const std::int32_t p : asked) moved_now_[std::size_t(p)] = 0;
}

// (eq. 41d) What has moved is known for all points: where the sample has moved more or less than it should,
// its missing work is wrong in proportion.
stress::VirtualWork Auditors::take() {
    const double missing = sum(missing_), moved = sum(moved_);
    missing_late_ = kMemory * missing_late_ + missing, moved_late_ = kMemory * moved_late_ + moved;
    const double ratio = moved_late_ > 0 ? missing_late_ / moved_late_ : 0;
    stress::VirtualWork out{known_ + missing + ratio * (moved_by_all_ - moved), 0};
    for (std::size_t p = 0; p < missing_.size(); ++p) {
        const double one = missing_spread_[p] - ratio * moved_spread_[p];
        out.variance += one * one;
    }
    known_ = moved_by_all_ = 0;
    for (auto* list : {&missing_, &missing_spread_, &moved_, &moved_spread_}) std::ranges::fill(*list, 0);
    return out;
}

std::size_t Auditors::measuring() const {
    return std::size_t(std::ranges::count_if(auditors_, [](const Auditor& a) { return a.chance > 0; }));
}

double Auditors::chance(std::int32_t point) const {
    const auto found = std::ranges::find(auditors_, point, &Auditor::point);
    return found == auditors_.end() ? 0 : found->chance;
}

void Auditors::save(ByteWriter& out) const {
    if (!present()) return;
    packings_.save(out);
    for (const auto* list : {&power_, &missing_, &missing_spread_, &moved_, &moved_spread_}) out.put(*list);
    out.put(moved_by_all_), out.put(known_), out.put(missing_late_), out.put(moved_late_);
    out.put(std::uint8_t(making_ready_)), out.put(next_draw_), out.put(std::uint64_t(auditors_.size()));
    for (const Auditor& a : auditors_) out.put(a.point), out.put(a.chance), out.put(a.next);
}

void Auditors::load(ByteReader& in) {
    if (!present()) return;
    packings_.load(in);
    for (auto* list : {&power_, &missing_, &missing_spread_, &moved_, &moved_spread_}) in.take_same(*list);
    in.take(moved_by_all_), in.take(known_), in.take(missing_late_), in.take(moved_late_);
    std::uint64_t size = 0;
    in.take(making_ready_), in.take(next_draw_), in.take(size);
    require_state(size <= power_.size() && next_draw_ >= 0, "auditors");
    auditors_.resize(size);
    for (Auditor& a : auditors_) in.take(a.point), in.take(a.chance), in.take(a.next);
    require_sound();
}

void Auditors::require_sound() const {
    for (std::size_t k = 0; k < auditors_.size(); ++k) {
        const Auditor& a = auditors_[k];
        require_indices(std::array{a.point}, power_.size(), "auditors");
        require_state(k == 0 || auditors_[k - 1].point < a.point, "auditors");
        require_state(a.chance >= 0 && a.chance <= 1 && a.next >= 0 && a.next <= 1, "auditors");
    }
}

}  // namespace sandgraph::graph

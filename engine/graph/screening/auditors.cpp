#include "graph/screening/auditors.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/contracts.hpp"
#include "graph/screening/power_draw.hpp"
#include "graph/stress_arithmetic.hpp"

namespace sandgraph::graph {
namespace {

constexpr double kFade = 0.5;  // of the power noted so far, at each draw: mechanisms move

// A mechanism forms early: draws are close at first.
constexpr double kFirst = 0.05, kGrowth = 0.3;  // of AuditSettings::every; of d/B

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
      work_(points, 0),
      spread_(points, 0) {}

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
    count_work(ground.batch);
    return steps;
}

void Auditors::record(const Followed& ground, std::span<const std::int32_t> asked, const Modes& modes) {
    for (const std::int32_t point : asked) {
        const auto p = std::size_t(point);
        if (modes.by_grains(p) || !ground.F[p].allFinite()) continue;
        const double pressure = std::fmax(0, mean_stress(ground.batch.stress[p]));
        power_[p] += volume_of(ground.batch, p) * pressure *
                     strain_between(packings_.recorded(point), ground.F[p]);
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
        if (drawn || held)
            all.push_back({std::int32_t(p), held ? old->chance : 0, drawn ? chance[p] : 0});
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
void Auditors::count_work(const stress::Batch& batch) {
    for (const Auditor& a : auditors_) {
        if (a.chance == 0) continue;
        const auto p = std::size_t(a.point);
        const Mat2& F_inc = batch.F_inc[p];
        turn(packings_.shortfall(a.point), F_inc);
        const double missing =
            volume_of(batch, p) * product(packings_.shortfall(a.point), small_strain(F_inc));
        work_[p] += missing / a.chance;
        spread_[p] += std::sqrt(1 - a.chance) / a.chance * missing;
    }
}

stress::VirtualWork Auditors::take() {
    stress::VirtualWork out{known_, 0};
    for (std::size_t p = 0; p < work_.size(); ++p)
        out.missing += work_[p], out.variance += spread_[p] * spread_[p];
    known_ = 0;
    std::ranges::fill(work_, 0), std::ranges::fill(spread_, 0);
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
    out.put(power_), out.put(work_), out.put(spread_), out.put(known_);
    out.put(std::uint8_t(making_ready_)), out.put(next_draw_), out.put(std::uint64_t(auditors_.size()));
    for (const Auditor& a : auditors_) out.put(a.point), out.put(a.chance), out.put(a.next);
}

void Auditors::load(ByteReader& in) {
    if (!present()) return;
    packings_.load(in);
    in.take_same(power_), in.take_same(work_), in.take_same(spread_), in.take(known_);
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

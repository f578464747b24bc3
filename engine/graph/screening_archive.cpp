#include <algorithm>
#include <array>

#include "base/byte_stream.hpp"
#include "graph/screening_law.hpp"

namespace sandgraph::graph {
namespace {

void put(ByteWriter& out, const std::vector<dem::Rve>& rves) {
    for (const dem::Rve& r : rves) r.save(out);
}
void take(ByteReader& in, std::vector<dem::Rve>& rves) {
    for (dem::Rve& r : rves) r.load(in);
}

bool known(Reason reason) { return static_cast<std::size_t>(reason) < reason_count; }

}  // namespace

// The sample comes from the setup; the scene's hash tells that it is the same.
void ScreeningLaw::archive(Archive& a) {
    confirm_packings(a, setup_.grains.rows);
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
    visits_.save(out);
    out.put(mode_), out.put(reason_), out.put(states_), out.put(blend_), out.put(fade_left_);
    for (std::size_t p = 0; p < size(); ++p) {
        out.put(std::span<const double>(F_[p].data(), 4));
        paths_[p].save(out);
    }
    put(out, rves_), put(out, audit_rves_);
    out.put(audit_errors_), out.put(fading_), out.put(static_cast<std::uint64_t>(dem_points_));
    out.put(next_audit_), out.put(audits_), out.put(switches_);
    out.put(counters_), out.put(screening_);
    felt_.save(out);
}

void ScreeningLaw::load(ByteReader& in) {
    visits_.load(in);
    in.take_same(mode_), in.take_same(reason_);
    in.take_same(states_), in.take_same(blend_), in.take_same(fade_left_);
    for (std::size_t p = 0; p < size(); ++p) {
        in.take(std::span<double>(F_[p].data(), 4));
        paths_[p].load(in);
    }
    take(in, rves_), take(in, audit_rves_);
    std::uint64_t points = 0;
    in.take_same(audit_errors_), in.take(fading_), in.take(points);
    dem_points_ = points;
    in.take(next_audit_), in.take(audits_), in.take(switches_);
    in.take(counters_), in.take(screening_);
    felt_.load(in, switches_.size());
    require_state(in.empty(), "lengths");
    require_sound();
}

void ScreeningLaw::require_sound() const {
    for (const PointMode mode : mode_) require_state(mode <= PointMode::flow, "modes");
    for (const Reason reason : reason_) require_state(known(reason), "reasons");
    require_indices(fading_, size(), "fading points");
    std::vector<std::int32_t> once = fading_;
    std::ranges::sort(once);
    require_state(std::ranges::adjacent_find(once) == once.end(), "fading points");
    for (const std::int32_t p : fading_) require_state(fade_left_[p] > 0, "fading points");
    require_state(next_audit_ >= 0, "audits");
    require_state(dem_points_ <= size(), "counts");
    for (const Switch& s : switches_) {
        require_state(known(s.reason), "switches");
        require_indices(std::array{s.point}, size(), "switches");
    }
}

}  // namespace sandgraph::graph

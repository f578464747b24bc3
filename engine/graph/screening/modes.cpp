#include "graph/screening/modes.hpp"

#include <algorithm>
#include <stdexcept>

namespace sandgraph::graph {
namespace {

const Transition* find(PointMode from, ModeEvent on) {
    const auto found =
        std::ranges::find_if(transitions, [&](const Transition& t) { return t.from == from && t.on == on; });
    return found == transitions.end() ? nullptr : found;
}

}  // namespace

Modes::Modes(std::size_t points, PointMode start)
    : mode_(points, start),
      reason_(points, Reason::none),
      grain_points_(answers_by_grains(start) ? points : 0) {}

bool Modes::allows(std::size_t point, ModeEvent event) const { return find(mode_[point], event) != nullptr; }

void Modes::apply(std::size_t point, ModeEvent event) {
    const Transition* const way = find(mode_[point], event);
    if (!way) throw std::logic_error("a point's constitutive mode has no way on from here");
    grain_points_ += answers_by_grains(way->to);
    grain_points_ -= answers_by_grains(way->from);
    mode_[point] = way->to;
}

void Modes::save(ByteWriter& out) const { out.put(mode_), out.put(reason_); }

void Modes::load(ByteReader& in) {
    in.take_same(mode_), in.take_same(reason_);
    for (const PointMode mode : mode_) require_state(static_cast<std::size_t>(mode) < mode_count, "modes");
    for (const Reason reason : reason_)
        require_state(static_cast<std::size_t>(reason) < stress::reason_count, "reasons");
    grain_points_ = static_cast<std::size_t>(std::ranges::count_if(mode_, answers_by_grains));
}

}  // namespace sandgraph::graph

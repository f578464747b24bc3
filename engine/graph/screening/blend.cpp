#include "graph/screening/blend.hpp"

#include <algorithm>
#include <cmath>

#include "base/contracts.hpp"
#include "graph/stress_arithmetic.hpp"

namespace sandgraph::graph {
namespace {

// Larger principal stress [Pa], tension positive.
double largest_tension(const Stress& s) {
    return 0.5 * (s.xx + s.yy) + std::hypot(0.5 * (s.xx - s.yy), s.xy);
}

}  // namespace

Stress tension_cut_off(const Stress& answered, Stress rest) {
    for (int halvings = 0; halvings < 6; ++halvings) {
        Stress sum = answered;
        add(sum, rest);
        if (largest_tension(sum) <= 0) return rest;
        rest = {0.5 * rest.xx, 0.5 * rest.yy, 0.5 * rest.xy};
    }
    return {};
}

void StressBlend::start(std::int32_t point, const Stress& jump) {
    SG_EXPECT(steps_ > 0);
    const auto p = static_cast<std::size_t>(point);
    if (steps_left_[p] == 0) fading_.push_back(point);
    rest_[p] = jump;
    steps_left_[p] = steps_;
}

void StressBlend::turn(std::int32_t point, const Mat2& F_inc) {
    const auto p = static_cast<std::size_t>(point);
    if (steps_left_[p] > 0) graph::turn(rest_[p], F_inc);
}

Stress StressBlend::on_top_of(const Stress& answered, std::size_t point) {
    if (fading(point)) rest_[point] = tension_cut_off(answered, rest_[point]);
    Stress sum = answered;
    add(sum, rest_[point]);
    return sum;
}

// docs/how_it_works.md (eq. 40).
void StressBlend::fade(std::span<const Mat2> F_inc, std::span<const double> volume, std::span<Stress> stress,
                       double& work) {
    SG_EXPECT(F_inc.size() == rest_.size() && stress.size() == rest_.size());
    SG_EXPECT(volume.empty() || volume.size() == rest_.size());
    ended_.clear();
    for (const std::int32_t point : fading_) {
        const auto p = static_cast<std::size_t>(point);
        const Mat2& F = F_inc[p];
        Stress& rest = rest_[p];
        const double done = rest.xx * (F(0, 0) - 1) + rest.yy * (F(1, 1) - 1) + rest.xy * (F(0, 1) + F(1, 0));
        if (!volume.empty()) work += done * volume[p];
        const double w = 1.0 / steps_left_[p]--;
        const Stress part = {w * rest.xx, w * rest.yy, w * rest.xy};
        rest = difference(rest, part);
        stress[p] = difference(stress[p], part);
        if (steps_left_[p] == 0) ended_.push_back(point);
    }
    std::erase_if(fading_, [&](std::int32_t p) { return steps_left_[static_cast<std::size_t>(p)] == 0; });
}

void StressBlend::save(ByteWriter& out) const { out.put(rest_), out.put(steps_left_), out.put(fading_); }

void StressBlend::load(ByteReader& in) {
    in.take_same(rest_), in.take_same(steps_left_), in.take(fading_);
    require_indices(fading_, rest_.size(), "fading points");
    std::vector<std::int32_t> once = fading_;
    std::ranges::sort(once);
    require_state(std::ranges::adjacent_find(once) == once.end(), "fading points");
    for (const std::int32_t p : fading_)
        require_state(steps_left_[static_cast<std::size_t>(p)] > 0, "fading points");
}

}  // namespace sandgraph::graph

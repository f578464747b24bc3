#include "graph/screening/felt_jumps.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "graph/stress_arithmetic.hpp"
#include "graph/visits.hpp"

namespace sandgraph::graph {

void FeltJumps::after(std::span<const Stress> stress, double floor, std::vector<Switch>& switches) {
    for (Watch& w : watches_) {
        const auto p = static_cast<std::size_t>(w.point);
        const double change = norm(difference(stress[p], before_[p])) / reference_pressure(stress[p], floor);
        Switch& s = switches[static_cast<std::size_t>(w.of)];
        double& largest = w.steps < fade_ ? s.felt : s.ordinary;
        largest = std::fmax(largest, change);  // of a NaN and a number the number
        ++w.steps;
    }
    forget_ended();
}

void FeltJumps::watch(const std::vector<Switch>& switches) {
    const std::int32_t point = switches.back().point;
    std::int32_t& place = watch_of_[static_cast<std::size_t>(point)];
    const Watch fresh{point, static_cast<std::int32_t>(switches.size()) - 1, 0};
    if (place >= 0) {
        watches_[static_cast<std::size_t>(place)] = fresh;
    } else {
        place = static_cast<std::int32_t>(watches_.size());
        watches_.push_back(fresh);
    }
}

void FeltJumps::forget_ended() {
    const auto ended = [&](const Watch& w) { return w.steps >= 2 * fade_; };
    if (std::ranges::none_of(watches_, ended)) return;
    for (const Watch& w : watches_) watch_of_[static_cast<std::size_t>(w.point)] = -1;
    std::erase_if(watches_, ended);
    for (std::size_t k = 0; k < watches_.size(); ++k)
        watch_of_[static_cast<std::size_t>(watches_[k].point)] = static_cast<std::int32_t>(k);
}

void FeltJumps::load(ByteReader& in, std::size_t switches) {
    in.take(watches_);
    std::ranges::fill(watch_of_, -1);
    for (std::size_t k = 0; k < watches_.size(); ++k) {
        const Watch& w = watches_[k];
        require_indices(std::array{w.of}, switches, "watches");
        require_indices(std::array{w.point}, watch_of_.size(), "watches");
        std::int32_t& place = watch_of_[static_cast<std::size_t>(w.point)];
        require_state(place < 0, "watches");
        place = static_cast<std::int32_t>(k);
    }
}

}  // namespace sandgraph::graph

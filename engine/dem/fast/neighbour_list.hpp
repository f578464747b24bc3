#pragma once
#include <vector>

#include "dem/fast/neighbours.hpp"
#include "dem/fast/state.hpp"
#include "dem/grain_scale.hpp"
#include "dem/packing/packing.hpp"

namespace sandgraph::dem {

// Pairs are listed up to this gap [m]: 0.3 mm for the grains of Table 1, by the largest radius for others.
inline double listed_gap(double radius_max) {
    constexpr double usual = 3e-4, usual_radius = 0.007;
    return usual * unless_near_one(radius_max / usual_radius);
}

// Keeps the pair list of a working state valid. One per thread is enough: it holds scratch memory only.
class NeighbourList {
  public:
    bool stale(const FastState& state) const { return state.approach >= listed_gap(state.radius_max); }

    // Re-reduces the cell if it is skewed, wraps the grains into it, lists the near pairs and hands `history`
    // (image counters as before the call) on to them. The stress is unchanged but for round-off.
    void relist(FastState& state, const std::vector<Contact>& history);
    // The same with the history the state itself holds.
    void rebuild(FastState& state);

    // Bound on how much closer two grains can have come in a step of dt [m]: twice the largest fluctuation
    // speed, and the mean field over the longest listed distance.
    double approach(const FastState& state, double speed2, double dt) const;

  private:
    void collect(const FastState& state, const std::vector<Contact>& history,
                 const Eigen::Matrix2i& U_inverse);
    void list_pairs(FastState& state, const std::vector<NearPair>& pairs);
    void deal(FastState& state, const std::vector<NearPair>& pairs, int first, int slots);
    const Contact* find(const NearPair& pair) const;

    NeighbourSearch search_;
    std::vector<Contact> history_, old_;  // old_: by first grain, image counters in the new cell
    std::vector<int> first_;              // [N + 1] start of each grain's contacts in old_
    std::vector<NearPair> inner_, outer_;
    std::vector<Wrapped> moved_;  // [N] periods taken off each grain
};

}  // namespace sandgraph::dem

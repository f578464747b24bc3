#pragma once
#include <vector>

#include "dem/fast/neighbours.hpp"
#include "dem/mixed/owners.hpp"
#include "dem/mixed/state.hpp"
#include "dem/packing/packing.hpp"

namespace sandgraph::dem {

// What a quiet grain is allowed to move while a list holds [m]; a fast one `kFast` times that at most.
double allowance(double radius_max);
inline constexpr float kFast = 4;

// Keeps the pairs of a mixed-precision state valid. One per thread is enough: it holds scratch memory only.
class MixedList {
  public:
    // Re-reduces the cell if it is skewed, lists the near pairs, touching ones first, and hands the history
    // that the state holds on to them. Positions and forces stay as they are to the bit; a move must come
    // before the next forces.
    void rebuild(MixedState& state);
    // The same with the history given.
    void relist(MixedState& state, const std::vector<Contact>& history);

    // Counts a move of dt whose kernel returned `rate2`; whether the list must be made anew.
    bool moved(MixedState& state, double rate2, double dt) const;

  private:
    void allow(MixedState& state);
    void find_pairs(const MixedState& state);
    void find_by_bins(const MixedState& state);
    double share_of_allowance(const MixedPacking& packing, const NearPair& pair) const;
    void sort_by_gap(const MixedPacking& packing);
    int dealt_pairs(int grains) const;
    void collect(int grains, const std::vector<Contact>& history);
    const Contact* find(const NearPair& pair) const;
    void lay_rows(MixedPacking& packing, const std::vector<std::int32_t>& owner);
    void deal(MixedPacking& packing, const std::vector<std::int32_t>& owner);
    void follow_loose(MixedPacking& packing, int dealt);
    void fill(MixedPacking& packing, std::size_t slot, int pair, bool first_owns) const;

    NeighbourSearch search_;
    PairOwners owners_;
    std::vector<double> centres_;         // [8 N] records for the search by bins
    Aligned<float> allowed_, reach_;      // [room] allowance; it and the radius
    std::vector<NearPair> found_;         // images left open
    std::vector<NearPair> pairs_;         // by gap, from class to class
    std::vector<int> class_of_;           // [pairs found]
    std::vector<int> class_end_;          // [classes] in pairs_
    std::vector<Contact> history_, old_;  // old_: i < j, by i
    std::vector<int> first_;              // [N + 1] start of each grain's contacts in old_
    std::vector<std::size_t> slot_;       // [room] next slot of each grain
};

// The pairs that hold a force, i < j, the image the nearest.
void contact_history(const MixedPacking& packing, std::vector<Contact>& out);

}  // namespace sandgraph::dem

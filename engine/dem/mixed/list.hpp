#pragma once
#include <vector>

#include "dem/fast/neighbours.hpp"
#include "dem/mixed/owners.hpp"
#include "dem/mixed/state.hpp"
#include "dem/packing/packing.hpp"

namespace sandgraph::dem {

// Pairs are listed up to this gap [m]; shorter than the double kernel's, for a search costs less here than
// the pairs that do not touch.
double mixed_gap(double radius_max);

// Keeps the pairs of a mixed-precision state valid. One per thread is enough: it holds scratch memory only.
class MixedList {
  public:
    bool stale(const MixedState& state) const {
        return state.packing.approach >= mixed_gap(state.radius_max);
    }

    // Re-reduces the cell if it is skewed, lists the near pairs, touching ones first, and hands the history
    // that the state holds on to them. Positions and forces stay as they are to the bit; a move must come
    // before the next forces.
    void rebuild(MixedState& state);
    // The same with the history given.
    void relist(MixedState& state, const std::vector<Contact>& history);

    // Bound on how much closer two grains can have come in a step of dt [m].
    double approach(const MixedState& state, double speed2, double dt) const;

  private:
    void list_pairs(const MixedState& state);
    void sort_touching_first(const MixedState& state);
    void collect(int grains, const std::vector<Contact>& history);
    const Contact* find(const NearPair& pair) const;
    void deal(MixedPacking& packing, const std::vector<std::int32_t>& owner);
    void fill(MixedPacking& packing, std::size_t slot, int pair, bool first_owns) const;

    NeighbourSearch search_;
    PairOwners owners_;
    std::vector<double> centres_;         // [8 N] records for the search
    std::vector<NearPair> pairs_, loose_;
    int touching_ = 0;                    // the first of pairs_
    std::vector<Contact> history_, old_;  // old_: i < j, by i
    std::vector<int> first_;              // [N + 1] start of each grain's contacts in old_
    std::vector<int> used_;               // [N] pairs dealt to each grain
};

// The pairs that hold a force, images as from the least branch.
void contact_history(const MixedPacking& packing, std::vector<Contact>& out);

// Periods to add to the second grain for the nearest image, and the branch in units of the cell.
struct NearestImage {
    std::int16_t cell_x, cell_y;
    std::int32_t x, y;
};
NearestImage nearest_image(const MixedPacking& packing, int i, int j);

// Calls visit(slot, i, j) for every listed pair.
template <class Visitor>
void for_each_pair(const MixedPacking& p, Visitor&& visit) {
    std::size_t slot = 0;
    for (std::size_t block = 0; block < p.rows.size(); ++block)
        for (int k = 0; k < MixedPacking::kLanes * p.rows[block]; ++k, ++slot) {
            const int i = static_cast<int>(block) * MixedPacking::kLanes + k % MixedPacking::kLanes;
            const int j = place_of(p.partner[slot]);
            if (i < p.grains && j < p.grains) visit(slot, i, j);
        }
}

}  // namespace sandgraph::dem

#pragma once
#include <vector>

#include "dem/fast/neighbours.hpp"

namespace sandgraph::dem {

// Hands every pair to one of its two grains, its first one in the pair loop, evenly: a lane per grain is then
// busy as long as the others. Holds scratch memory only.
class PairOwners {
  public:
    // Owners of pairs [0, count) of `pairs`, i or j of each. The first `touching` are dealt out by themselves,
    // so that they are spread evenly and the others over what is left.
    const std::vector<std::int32_t>& share(const std::vector<NearPair>& pairs, int touching, int grains);

  private:
    void deal(const std::vector<NearPair>& pairs, int begin, int end);
    void list_pairs_by_grain(const std::vector<NearPair>& pairs, int begin, int end);
    bool relieve(const std::vector<NearPair>& pairs, int grain, int most);
    void hand_on(const std::vector<NearPair>& pairs, int last);

    std::vector<std::int32_t> owner_;            // [pairs]
    std::vector<int> load_;                      // [N] pairs owned
    std::vector<int> first_, of_grain_;          // pairs of the part dealt out, by grain
    std::vector<int> reached_, came_by_, todo_;  // of a search
    int search_ = 0;
};

}  // namespace sandgraph::dem

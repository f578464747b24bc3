#pragma once
#include <vector>

#include "dem/fast/neighbours.hpp"

namespace sandgraph::dem {

// Hands every pair to one of its two grains, its first one in the pair loop, evenly: a lane per grain is then
// busy as long as the others. Holds scratch memory only.
class PairOwners {
  public:
    // Owner, i or j, of each of the first `count` pairs.
    const std::vector<std::int32_t>& share(const std::vector<NearPair>& pairs, int count, int grains);

  private:
    void list_pairs_by_grain(const std::vector<NearPair>& pairs, int count);
    bool relieve(const std::vector<NearPair>& pairs, int grain, int most);
    void hand_on(const std::vector<NearPair>& pairs, int last);

    std::vector<std::int32_t> owner_;            // [pairs]
    std::vector<int> load_;                      // [N] pairs owned
    std::vector<int> first_, of_grain_;          // pairs by grain
    std::vector<int> reached_, came_by_, todo_;  // of a search
    int search_ = 0;
};

}  // namespace sandgraph::dem

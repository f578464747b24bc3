#include "dem/mixed/owners.hpp"

#include <algorithm>

#include "base/contracts.hpp"

namespace sandgraph::dem {
namespace {

int other(const NearPair& p, int grain) { return p.i == grain ? p.j : p.i; }

}  // namespace

// To the grain that has fewer; then those with more than their share hand on.
const std::vector<std::int32_t>& PairOwners::share(const std::vector<NearPair>& pairs, int count,
                                                   int grains) {
    SG_EXPECT(count >= 0 && static_cast<std::size_t>(count) <= pairs.size() && grains > 0);
    owner_.resize(count);
    load_.assign(grains, 0);
    for (int k = 0; k < count; ++k) {
        const NearPair& p = pairs[k];
        owner_[k] = load_[p.i] <= load_[p.j] ? p.i : p.j;
        ++load_[owner_[k]];
    }
    const int most = (count + grains - 1) / grains;
    list_pairs_by_grain(pairs, count);
    reached_.assign(grains, 0), came_by_.resize(grains), search_ = 0;
    for (int g = 0; g < grains; ++g)
        while (load_[g] > most && relieve(pairs, g, most)) {
        }
    return owner_;
}

void PairOwners::list_pairs_by_grain(const std::vector<NearPair>& pairs, int count) {
    first_.assign(load_.size() + 1, 0);
    of_grain_.resize(2 * static_cast<std::size_t>(count));
    for (int k = 0; k < count; ++k) ++first_[pairs[k].i], ++first_[pairs[k].j];
    int sum = 0;
    for (int& start : first_) sum += start, start = sum;
    for (int k = count; k-- > 0;) of_grain_[--first_[pairs[k].i]] = k, of_grain_[--first_[pairs[k].j]] = k;
}

// Breadth first along owned pairs to the nearest grain with room, within reach; each on the way takes one and
// gives one.
bool PairOwners::relieve(const std::vector<NearPair>& pairs, int grain, int most) {
    constexpr std::size_t kReach = 100;
    ++search_;
    todo_.assign(1, grain), reached_[grain] = search_, came_by_[grain] = -1;
    for (std::size_t t = 0; t < todo_.size() && t < kReach; ++t) {
        const int from = todo_[t];
        for (int at = first_[from]; at < first_[from + 1]; ++at) {
            const int pair = of_grain_[at], to = other(pairs[pair], from);
            if (owner_[pair] != from || reached_[to] == search_) continue;
            reached_[to] = search_, came_by_[to] = pair;
            if (load_[to] < most) return hand_on(pairs, to), true;
            todo_.push_back(to);
        }
    }
    return false;
}

void PairOwners::hand_on(const std::vector<NearPair>& pairs, int last) {
    ++load_[last];
    int grain = last;
    while (came_by_[grain] >= 0) {
        const int pair = came_by_[grain], giver = other(pairs[pair], grain);
        owner_[pair] = grain, grain = giver;
    }
    --load_[grain];
}

}  // namespace sandgraph::dem

#include "ranks/owners.hpp"

#include <algorithm>
#include <numeric>
#include <set>

#include "base/contracts.hpp"

namespace sandgraph::ranks {
namespace {

// The work of each rank, and its packings by their cost.
class Shares {
  public:
    Shares(const std::vector<int>& rank, const std::vector<std::int64_t>& cost,
           std::vector<std::int64_t> loads)
        : loads_(std::move(loads)), packings_(loads_.size()) {
        for (std::size_t k = 0; k < rank.size(); ++k)
            if (cost[k] > 0) packings_[static_cast<std::size_t>(rank[k])].emplace(cost[k], k);
    }
    // Whether some rank has more than `factor` times the mean.
    bool uneven(double factor) const { return double(loads_[most()]) > factor * mean(); }

    // The best move of the most loaded rank; false where each would only turn the gap round.
    bool narrow(Owners::Move& move) {
        const std::size_t from = most(), to = least();
        auto& giving = packings_[from];
        auto found = giving.upper_bound({(loads_[from] - loads_[to]) / 2, ~std::size_t{0}});
        if (found == giving.begin()) return false;
        const auto [cost, packing] = *--found;
        giving.erase(found);
        packings_[to].emplace(cost, packing);
        loads_[from] -= cost, loads_[to] += cost;
        move = {packing, static_cast<int>(from), static_cast<int>(to)};
        return true;
    }

  private:
    // Of equal ones the first.
    std::size_t most() const { return std::size_t(std::ranges::max_element(loads_) - loads_.begin()); }
    std::size_t least() const { return std::size_t(std::ranges::min_element(loads_) - loads_.begin()); }
    double mean() const {
        return double(std::accumulate(loads_.begin(), loads_.end(), std::int64_t{0})) / double(loads_.size());
    }
    std::vector<std::int64_t> loads_;
    std::vector<std::set<std::pair<std::int64_t, std::size_t>>> packings_;
};

}  // namespace

Owners::Owners(std::size_t packings, int ranks) : rank_(packings), cost_(packings, 0), ranks_(ranks) {
    SG_EXPECT(ranks >= 1);
    for (std::size_t k = 0; k < packings; ++k)
        rank_[k] = static_cast<int>(k % static_cast<std::size_t>(ranks));
}

std::vector<std::int64_t> Owners::loads() const {
    std::vector<std::int64_t> out(static_cast<std::size_t>(ranks_), 0);
    for (std::size_t k = 0; k < rank_.size(); ++k) out[static_cast<std::size_t>(rank_[k])] += cost_[k];
    return out;
}

double Owners::imbalance() const {
    const std::vector<std::int64_t> all = loads();
    const auto sum = std::accumulate(all.begin(), all.end(), std::int64_t{0});
    return sum > 0 ? double(*std::ranges::max_element(all)) * ranks_ / double(sum) : 1;
}

std::vector<Owners::Move> Owners::balance() {
    std::vector<Move> moves;
    if (imbalance() > tolerated) {
        Shares shares(rank_, cost_, loads());
        for (Move m{}; shares.uneven(settled) && shares.narrow(m);) moves.push_back(m);
    }
    for (const Move& m : moves) rank_[m.packing] = m.to;
    for (std::int64_t& cost : cost_) cost /= 2;
    return moves;
}

}  // namespace sandgraph::ranks

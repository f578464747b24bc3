#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace sandgraph::ranks {

// Which rank drives which packing. Every rank keeps the same table: it follows from DEM steps counted, which
// are the same everywhere and at every run, and from no clock.
class Owners {
  public:
    // In turn at first: neighbours, which strain together, lie on different ranks.
    Owners(std::size_t packings, int ranks);

    int of(std::size_t packing) const { return rank_[packing]; }
    void measure(std::size_t packing, std::int64_t dem_steps) { cost_[packing] += dem_steps; }
    void move(std::size_t packing, int rank) { rank_[packing] = rank; }

    struct Move {
        std::size_t packing;
        int from, to;
        bool operator==(const Move&) const = default;
    };
    // Moves packings from the rank with most work to the one with least, the largest first that narrow the
    // gap, until no rank has more than `settled` times the mean. Nothing moves while none has more than
    // `tolerated` times the mean: a packing's own costs waver by more than a move gains. What was measured
    // counts half from then on.
    std::vector<Move> balance();
    static constexpr double tolerated = 1.05, settled = 1.02;

    double imbalance() const;  // the most loaded rank's work over the mean; 1 where there is none

  private:
    std::vector<std::int64_t> loads() const;  // by rank
    std::vector<int> rank_;                   // by packing
    std::vector<std::int64_t> cost_;          // by packing, DEM steps, those of long ago faded
    int ranks_;
};

}  // namespace sandgraph::ranks

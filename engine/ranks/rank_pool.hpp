#pragma once
#include <map>
#include <mutex>
#include <optional>

#include "graph/rve_pool.hpp"
#include "ranks/answer_record.hpp"
#include "ranks/orders.hpp"
#include "ranks/owners.hpp"
#include "ranks/team.hpp"

namespace sandgraph::ranks {

// What the exchange has cost so far; the same on all ranks but for `driven`.
struct PoolFigures {
    std::int64_t exchanges = 0, waits = 0;  // waits: for rank 0's word, where it might look at packings
    std::int64_t bytes = 0;                 // of answers, of all ranks
    std::int64_t moved = 0;                 // packings that changed their rank
    std::int64_t dem_steps = 0;             // of all ranks
    std::int64_t slowest = 0;               // of them, step by step, those of the rank that had most
};

// The packings of a run shared out among ranks. Every rank computes the same macro step and hands in the same
// jobs; each drives those of its own packings, and one collective a call tells all of them the answers. The
// bits are those of a pool in one process.
//
// Rank 0 may look at any packing between two steps (rve, save): the others then wait for its word before they
// drive on. `announce(false)` says before a step that this will not be, and spares the wait.
class RankPool final : public graph::RvePool {
  public:
    RankPool(Team& team, const graph::InitialPackings& initial, const dem::Material& material,
             const dem::RveOptions& options);

    void drive(std::span<const graph::RveJob> jobs, std::span<graph::RveAnswer> answers) override;
    Mat2 stress(std::size_t rve) const override { return known_[rve].stress; }
    double strain_per_step(std::size_t rve) const override { return known_[rve].strain_per_step; }
    double porosity(std::size_t rve) const override { return known_[rve].porosity; }
    // The receiver moves to where the giver lives: nothing travels.
    void copy(std::size_t from, std::size_t to) override;
    std::size_t owning() const override;
    // On rank 0 any, as it is now, until the next drive; elsewhere the rank's own.
    const dem::Rve& rve(std::size_t rve) const override;

    void save(ByteWriter& out) const override;  // by rank 0
    void load(ByteReader& in) override;         // by all ranks, of the same bytes
    void save_one(std::size_t rve, ByteWriter& out) const override;
    void load_one(std::size_t rve, ByteReader& in) override;

    void announce(bool looked_at) { will_look_ = looked_at; }
    // By a rank that is ready for its first step: until rank 0 is. False where there will be none.
    bool await();
    // By a rank that has no step left to take: shows packings until rank 0 says stop, then throws Dismissed.
    void serve();
    const Owners& owners() const { return owners_; }
    const PoolFigures& figures() const { return figures_; }

  private:
    bool mine(std::size_t rve) const { return owners_.of(rve) == team_.rank(); }
    void require_same_packings(const graph::InitialPackings& initial);
    void meet();
    void drive_own(std::span<const graph::RveJob> jobs);
    void exchange(std::span<const graph::RveJob> jobs, std::span<graph::RveAnswer> answers);
    void take_all(std::span<const graph::RveJob> jobs, std::span<graph::RveAnswer> answers);
    std::vector<ByteReader> open_messages();
    void count(std::span<const graph::RveJob> jobs, std::span<const graph::RveAnswer> answers);
    void balance();
    void move(const Owners::Move& one);
    void release(std::size_t rve);
    void note(std::size_t rve);
    void show(std::size_t first, std::size_t last);
    std::vector<Bytes> ask_to_show(std::size_t first, std::size_t last) const;
    const dem::Rve& fetch(std::size_t rve) const;

    Team& team_;
    graph::InitialPackings initial_;
    std::unique_ptr<graph::RvePool> local_;  // of all packings; those of others stay as they were at first
    bool caps_;                              // updates may stop on their way
    Owners owners_;
    std::vector<KnownPacking> known_;  // by packing
    Bytes untouched_;                  // the state of a packing that has not been driven
    bool will_look_ = true;            // rank 0, after the next exchange
    bool waits_ = true;                // the others wait for rank 0's word
    std::optional<Order> heard_;       // and not followed yet
    PoolFigures figures_;

    // Of this call.
    std::vector<std::size_t> sizes_;  // by rank [B]
    Bytes records_, all_;
    std::vector<graph::RveJob> own_;
    std::vector<graph::RveAnswer> own_answers_;

    mutable std::mutex fetching_;
    mutable std::map<std::size_t, std::unique_ptr<dem::Rve>> guests_;  // rank 0: fetched since the last drive
};

}  // namespace sandgraph::ranks

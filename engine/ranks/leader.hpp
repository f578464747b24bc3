#pragma once
#include "ranks/rank_pool.hpp"
#include "ranks/team.hpp"
#include "simulation/crew.hpp"

namespace sandgraph::ranks {

// Rank 0's side of a run: it has the others build the same simulation, and writes what comes out. Whoever
// owns the team tells them to stop in the end, whatever became of the run.
class Leader final : public simulation::Crew {
  public:
    explicit Leader(Team& team) : team_(team) {}
    int size() const override { return team_.size(); }
    int threads() const override;
    void begin(const simulation::RunRequest& request, const simulation::RunOptions& options,
               const std::string& scene_hash) override;
    graph::PoolMaker pool() override;
    void announce(bool looked_at) override;
    std::string account() const override;

  private:
    Team& team_;
    RankPool* pool_ = nullptr;  // the law's
};

// Cores of this machine for each rank on it.
int threads_a_rank(const Team& team);

}  // namespace sandgraph::ranks

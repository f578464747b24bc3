#include "ranks/leader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "ranks/beginning.hpp"
#include "simulation/run_request.hpp"

namespace sandgraph::ranks {

int threads_a_rank(const Team& team) {
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()) / team.here());
}

int Leader::threads() const { return threads_a_rank(team_); }

void Leader::begin(const simulation::RunRequest& request, const simulation::RunOptions& options,
                   const std::string& scene_hash) {
    Bytes run = packed({request, std::filesystem::absolute(options.folder).string(), scene_hash,
                        options.threads, options.resume, options.until});
    tell(team_, {Order::Kind::begin, 0, run.size()});
    team_.broadcast(run);
}

graph::PoolMaker Leader::pool() {
    return [this](const graph::InitialPackings& initial, const dem::Material& material,
                  const dem::RveOptions& options) {
        auto pool = std::make_unique<RankPool>(team_, initial, material, options);
        pool_ = pool.get();
        return pool;
    };
}

void Leader::announce(bool looked_at) {
    if (pool_) pool_->announce(looked_at);
}

std::string Leader::account() const {
    const PoolFigures f = pool_ ? pool_->figures() : PoolFigures{};
    const double steps = double(f.dem_steps), slowest = double(f.slowest);
    return fmt::format(
        "{} ranks: {} exchanges of {:.0f} B on average, {} waits, {} packings moved, DEM steps "
        "{:.0f} % even",
        team_.size(), f.exchanges, double(f.bytes) / double(std::max<std::int64_t>(1, f.exchanges)), f.waits,
        f.moved, slowest > 0 ? 100 * steps / (team_.size() * slowest) : 100);
}

}  // namespace sandgraph::ranks

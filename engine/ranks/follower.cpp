#include "ranks/follower.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <stdexcept>

#include "base/error.hpp"
#include "base/hash.hpp"
#include "io/checkpoint.hpp"
#include "ranks/beginning.hpp"
#include "ranks/rank_pool.hpp"
#include "scene/scene_hash.hpp"
#include "simulation/history_recorder.hpp"
#include "simulation/prepare_run.hpp"
#include "simulation/scene_spec.hpp"

namespace sandgraph::ranks {
namespace {

constexpr double kReached = 1e-9;  // slack on marks

// Rank 0's simulation once more, with this rank's packings in it.
class Follower {
  public:
    Follower(Team& team, Beginning run) : team_(team), run_(std::move(run)) {}

    // Rank 0 has done the same before it called: what fails here is this rank's own.
    void prepare() {
        scene_ = simulation::scene_of(run_.request);
        if (hex(scene::scene_hash(scene_)) != run_.scene_hash)
            throw std::runtime_error(run_.request.scene + " is another scene here");
        ground_ = simulation::prepare_quietly(scene_);
    }

    // What is thrown from here on, rank 0 throws as well, and tells it.
    void build() {
        simulation_ = simulation::simulation_of(scene_, ground_, maker());
        if (scene_.output.history) simulation::watch_history(*simulation_, scene_);
    }

    // Rank 0 has read it and was content.
    void resume() {
        if (!run_.resume) return;
        io::CheckpointReader reader(std::filesystem::path(run_.folder) / io::checkpoint_name,
                                    run_.scene_hash);
        simulation_->archive(reader);
    }

    void take_steps() {
        while (simulation_->mark() < run_.until - kReached) simulation_->step();
        pool_->serve();
    }

    RankPool& pool() { return *pool_; }

  private:
    graph::PoolMaker maker() {
        return [this](const graph::InitialPackings& initial, const dem::Material& material,
                      const dem::RveOptions& options) {
            auto pool = std::make_unique<RankPool>(team_, initial, material, options);
            pool_ = pool.get();
            return pool;
        };
    }

    Team& team_;
    Beginning run_;
    scene::Scene scene_;
    packings::PreparedGround ground_;
    std::unique_ptr<simulation::Simulation> simulation_;
    RankPool* pool_ = nullptr;
};

template <class Work>
void alone(Team& team, const Work& work) try {
    work();
} catch (const std::exception& error) {
    team.abandon(error.what());
}

void run(Team& team, Beginning what) {
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(what.threads));
    Follower follower(team, std::move(what));
    alone(team, [&] { follower.prepare(); });
    follower.build();
    if (!follower.pool().await()) throw Dismissed();
    alone(team, [&] { follower.resume(); });
    follower.take_steps();
}

// Where all ranks come to the same error, rank 0 tells it and says stop.
void run_to_its_end(Team& team, Beginning what) try { run(team, std::move(what)); } catch (const Dismissed&) {
    throw;
} catch (const std::runtime_error&) {
} catch (const std::exception& error) {
    team.abandon(error.what());
}

}  // namespace

void follow(Team& team) try {
    for (;;) {
        const Order order = hear(team);
        if (order.kind == Order::Kind::stop) return;
        if (order.kind != Order::Kind::begin) continue;
        Bytes run(order.last);
        team.broadcast(run);
        run_to_its_end(team, unpacked(run));
    }
} catch (const Dismissed&) {
}

}  // namespace sandgraph::ranks

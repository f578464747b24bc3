#include "simulation/run_checkpoint.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/revision.hpp"
#include "io/checkpoint.hpp"

namespace sandgraph::simulation {

RunCheckpoint::RunCheckpoint(std::filesystem::path folder, std::string scene_hash, double every)
    : folder_(std::move(folder)), scene_hash_(std::move(scene_hash)), every_(every) {}

void RunCheckpoint::write(double d_over_B, const Parts& parts) {
    io::CheckpointWriter out(folder_ / io::checkpoint_name, {scene_hash_, revision(), d_over_B});
    parts(out);
    out.commit();
    last_ = wall_clock();
}

void RunCheckpoint::read(const Parts& parts) const {
    io::CheckpointReader reader(folder_ / io::checkpoint_name, scene_hash_);
    if (!reader.notice().empty()) notice(reader.notice());
    try {
        parts(reader);
    } catch (const StateError& error) {
        throw InputError({(folder_ / io::checkpoint_name).string()},
                         "the checkpoint is none of this program's runs of this scene",
                         fmt::format("{}; it was written by revision {}, this is {}", error.what(),
                                     reader.header().git, revision()),
                         "resume with the program that wrote it, or start anew, without --resume");
    }
}

}  // namespace sandgraph::simulation

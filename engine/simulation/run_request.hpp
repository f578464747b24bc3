#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "io/folder_lock.hpp"
#include "scene/scene.hpp"
#include "simulation/crew.hpp"

namespace sandgraph::simulation {

// What `sandgraph run` is asked for.
struct RunRequest {
    std::string scene, folder, mode;  // files; mode "": the scene's
    std::vector<std::string> set;     // section.key=value
    int threads = 0;                  // 0: all cores
    bool resume = false;
    double until = 0;            // d/B (without an anchor time [s]) at which to stop; 0: the scene's end
    std::shared_ptr<Crew> crew;  // null: alone
};

// The same, decided.
struct RunOptions {
    std::filesystem::path folder;
    std::shared_ptr<io::FolderLock> owner;  // as long as the run is going on
    int threads = 0;
    double until = 0;       // mark at which to stop
    bool resume = false;    // there is a checkpoint to go on from
    bool finished = false;  // there is nothing left to do
    std::shared_ptr<Crew> crew;
};

int threads_of(const RunRequest& request);

// The checked scene of a request, with the surrogate's file found.
scene::Scene scene_of(const RunRequest& request);

// A word as a shell takes it.
std::string shell_word(const std::string& word);

// What to type to go on with a run that was stopped; words as a shell takes them.
std::string resume_command(const RunRequest& request, const std::filesystem::path& folder);

}  // namespace sandgraph::simulation

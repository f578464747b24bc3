#include "simulation/run_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "base/error.hpp"
#include "base/text.hpp"
#include "packings/packing_material.hpp"
#include "scene/read_scene.hpp"
#include "simulation/build_screening.hpp"

namespace sandgraph::simulation {
namespace {

// What is said twice on the command line is a slip.
void refuse_twice(const RunRequest& a) {
    const auto sets = [&a](std::string_view key) {
        return std::ranges::any_of(a.set, [key](const std::string& assignment) {
            return trimmed(std::string_view(assignment).substr(0, assignment.find('='))) == key;
        });
    };
    if (!a.mode.empty() && sets("mode"))
        throw InputError({"--mode"}, a.mode, "--set mode=... says it, too", "leave one of them out");
    if (!a.folder.empty() && sets("output.folder"))
        throw InputError({"--out"}, a.folder, "--set output.folder=... says it, too",
                         "leave one of them out");
}

}  // namespace

std::string shell_word(const std::string& word) {
    const bool plain = word.find_first_of(" \"'$&|;<>()[]*?#~\\`!{}") == std::string::npos && !word.empty();
    if (plain) return word;
    std::string out = "'";
    for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return out + "'";
}

int threads_of(const RunRequest& a) {
    if (a.threads > 0) return a.threads;
    return a.crew ? a.crew->threads() : static_cast<int>(std::thread::hardware_concurrency());
}

scene::Scene scene_of(const RunRequest& a) {
    refuse_twice(a);
    std::vector<std::string> overrides = a.set;
    if (!a.mode.empty()) overrides.push_back("mode=" + a.mode);
    scene::Scene scene = scene::read_scene(a.scene, overrides);
    packings::take_packing_material(scene.ground.grains, scene.given);
    if (scene.mode == scene::Mode::screening) {
        if (scene.ground.law != scene::Law::rve)
            throw InputError(a.mode.empty() ? scene.where("mode") : InputError::Where{"--mode"},
                             "mode = \"screening\" of a closed-form law",
                             "a surrogate stands in for packings of grains", "write ground.law = \"rve\"");
        scene.screening.model = model_file(scene).string();
    }
    return scene;
}

std::string resume_command(const RunRequest& a, const std::filesystem::path& folder) {
    std::string out = fmt::format("sandgraph run {} -o {}", shell_word(a.scene), shell_word(folder.string()));
    if (!a.mode.empty()) out += " --mode " + a.mode;
    for (const std::string& assignment : a.set) out += " --set " + shell_word(assignment);
    if (a.threads > 0) out += fmt::format(" --threads {}", a.threads);
    if (a.until > 0) out += fmt::format(" --until {}", a.until);
    return out + " --resume";
}

}  // namespace sandgraph::simulation

#include "simulation/build_screening.hpp"

#include "base/error.hpp"

namespace sandgraph::simulation {
namespace {

namespace fs = std::filesystem;

constexpr const char* kShipped = "table1.surrogate.h5";

// `name` in `folder`, in its folders of models, or in those of the folders above it.
fs::path found_above(fs::path folder, const char* name) {
    for (;; folder = folder.parent_path()) {
        for (const char* place : {"", "models", "configs/models", "configs"})
            if (fs::exists(folder / place / name)) return folder / place / name;
        if (!folder.has_relative_path()) return {};
    }
}

}  // namespace

fs::path model_file(const scene::Scene& scene) {
    if (!scene.screening.model.empty()) return scene.screening.model;
    std::error_code unknown;
    const fs::path program = fs::read_symlink("/proc/self/exe", unknown);
    for (const fs::path& from : {fs::absolute(scene.file).lexically_normal(), program})
        if (const fs::path found = found_above(from.parent_path(), kShipped); !found.empty()) return found;
    throw InputError(scene.where("mode"), "mode = \"screening\" without a surrogate",
                     std::string("no ") + kShipped + " beside the scene or the program",
                     "give [surrogate] model = \"FILE.h5\" (sandgraph train makes one)");
}

std::unique_ptr<stress::Law> screening_law(const scene::Scene& scene, const packings::PreparedGround& ground,
                                           graph::RveLawSetup grains) {
    return std::make_unique<graph::ScreeningLaw>(
        graph::ScreeningSetup{scene.screening, std::move(grains), ground.surrogate, ground.traits});
}

io::ScreeningRecord screening_record(const stress::Law& law) {
    io::ScreeningRecord out;
    const stress::ScreeningLog* log = law.screening_log();
    if (!log) return out;
    out.reasons.assign(stress::reason_names.begin(), stress::reason_names.end());
    out.switches = log->switches, out.audits = log->audits;
    return out;
}

}  // namespace sandgraph::simulation

#include "app/finished_run.hpp"

#include <cmath>

#include "base/error.hpp"
#include "scene/read_scene.hpp"

namespace sandgraph::app {

namespace fs = std::filesystem;

fs::path plain_folder(const fs::path& folder) {
    fs::path plain = folder.lexically_normal();
    if (!plain.has_filename()) plain = plain.parent_path();  // of "r1/"
    return plain.filename() == "." || plain.filename() == ".." ? fs::weakly_canonical(plain) : plain;
}

FinishedRun read_finished_run(const fs::path& given) {
    const fs::path folder = plain_folder(given);
    if (!fs::exists(folder / "run.h5"))
        throw InputError({folder.string()}, "no run", "a run folder holds run.h5",
                         "give the folder that `sandgraph run -o DIR` wrote");
    if (!fs::exists(folder / "summary.json"))
        throw InputError({folder.string()}, "the run has not ended", "there is no summary.json",
                         "finish it with `sandgraph run ... --resume`");
    FinishedRun run;  // member by member: GCC 12 frees an aggregate twice when one of its initialisers throws
    run.folder = folder;
    run.record = io::read_run(folder / "run.h5");
    run.summary = io::read_summary(folder / "summary.json");
    run.scene = scene::recorded_scene(run.record.info.scene_text, folder.filename().string());
    return run;
}

std::string title_of(const scene::Scene& scene) {
    if (!scene.title.empty()) return scene.title;
    const fs::path file = scene.file;  // of a run read back its folder, whose name may hold a dot
    return (file.extension() == ".toml" ? file.stem() : file.filename()).string();
}

double embedment_of(const FinishedRun& run) {
    const double equivalent = run.summary.number("equivalent_embedment_ratio");
    return std::isfinite(equivalent) ? equivalent : run.scene.anchor.embedment_ratio;
}

bool pulled_up(const scene::Scene& scene) {
    return scene.anchor.orientation == scene::Orientation::horizontal;
}

}  // namespace sandgraph::app

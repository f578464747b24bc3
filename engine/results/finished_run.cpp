#include "results/finished_run.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/error.hpp"
#include "scene/read_scene.hpp"

namespace sandgraph::results {

namespace {

namespace fs = std::filesystem;

bool is_run(const fs::path& folder) {
    return fs::exists(folder / "run.h5") && fs::exists(folder / "summary.json");
}

}  // namespace

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

std::vector<FinishedRun> find_runs(const std::vector<std::string>& folders) {
    std::vector<fs::path> found;
    std::set<fs::path> seen;  // however they were written
    const auto take = [&](const fs::path& folder) {
        if (is_run(folder) && seen.insert(fs::canonical(folder)).second)
            found.push_back(plain_folder(folder));
    };
    for (const std::string& folder : folders) {
        if (!fs::is_directory(folder))
            throw InputError({folder, 0}, "no such folder", "a report is made from run folders",
                             "check the path");
        take(folder);
        for (const auto& entry : fs::recursive_directory_iterator(folder))
            if (entry.is_directory()) take(entry.path());
    }
    std::sort(found.begin(), found.end());
    if (found.empty())
        throw InputError({folders.front(), 0}, "no finished run",
                         "a run folder holds run.h5 and summary.json",
                         "run a scene first: sandgraph run SCENE.toml -o DIR");
    std::vector<FinishedRun> runs;
    for (const fs::path& folder : found) runs.push_back(read_finished_run(folder));
    return runs;
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

double unit_weight(const FinishedRun& run) {
    return run.summary.number("density_kg_per_m3") * run.scene.ground.gravity;
}

bool pulled_up(const scene::Scene& scene) {
    return scene.anchor.orientation == scene::Orientation::horizontal;
}

}  // namespace sandgraph::results

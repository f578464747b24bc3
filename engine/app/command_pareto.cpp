#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdlib>

#include "app/command_line.hpp"
#include "app/commands.hpp"
#include "base/error.hpp"
#include "io/atomic_file.hpp"
#include "io/folder_lock.hpp"
#include "report/pareto_picture.hpp"
#include "report/run_pictures.hpp"
#include "results/pareto_study.hpp"

namespace sandgraph::app {
namespace {

report::ParetoPicture picture_of(const std::vector<results::ParetoRow>& rows, const std::string& title) {
    report::ParetoPicture picture{"Speed against error: " + title, {}};
    for (const results::ParetoRow& r : rows)
        picture.marks.push_back({r.label, r.against.wall_ratio, r.against.peak_error, r.against.curve_error,
                                 r.against.audit_mean, r.against.audit_ci95, r.true_error});
    return picture;
}

int study(const results::ParetoRequest& request) {
    const std::filesystem::path folder = request.run.folder;
    const io::FolderLock owner(folder);
    const auto rows = results::pareto_study(request);
    if (!rows) {
        fmt::print(stderr, "stopped; the same command goes on\n");
        return exit_stopped_early;
    }
    const std::string csv = results::to_csv(*rows);
    io::write_text(folder / "pareto.csv", csv);
    fmt::print("{}", csv);
    const report::Picture drawn = report::draw_pareto_picture(
        picture_of(*rows, results::title_of(simulation::scene_of(request.run))), folder / "pareto.png");
    fmt::print("{}\n", drawn.drawn ? "results in " + folder.string() : "no picture: " + drawn.message);
    return exit_done;
}

// "0.003" or "0.003:0.1"
bool is_threshold(const std::string& word) {
    const char* at = word.c_str();
    char* end = nullptr;
    std::strtod(at, &end);
    if (end == at || (*end != ':' && *end != '\0')) return false;
    if (*end == '\0') return true;
    std::strtod(at = end + 1, &end);
    return end != at && *end == '\0';
}

// Words that stand alone: the scene, and thresholds behind the first of --thresholds.
void sort_words(const std::vector<std::string>& words, bool asked, results::ParetoRequest& request) {
    const InputError::Where here{"sandgraph pareto", 0};
    for (const std::string& word : words)
        if (asked && is_threshold(word))
            request.thresholds.push_back(word);
        else if (request.run.scene.empty())
            request.run.scene = word;
        else
            throw InputError(here, fmt::format("unknown argument \"{}\"", word), "one scene is studied",
                             "sandgraph pareto --help lists what there is");
    if (request.run.scene.empty())
        throw InputError(here, "scene is required", "none is named", "name a TOML file");
}

}  // namespace

void add_pareto_command(CLI::App& app, int& exit_code) {
    auto a = std::make_shared<results::ParetoRequest>();
    a->thresholds = {"0.003:0", "0.003:0.3", "0.003:0.1", "0.003:0.03", "0.01:0.1", "0.01:0.03"};
    CLI::App* command = app.add_subcommand(
        "pareto", "speed against error: one scene at several gate thresholds, and at full fidelity");
    auto words = std::make_shared<std::vector<std::string>>();
    command->add_option("scene", *words, "TOML file")->required();
    command->add_option("-o,--out", a->run.folder, "folder of all runs, pareto.csv and pareto.png")
        ->required();
    CLI::Option* thresholds = command->add_option(
        "--thresholds", a->thresholds, "of gate.strain, or of gate.strain:gate.flow, one or several");
    thresholds->delimiter(',')->allow_extra_args(false);
    command->add_option("--set", a->run.set, "section.key=value for all runs; may be repeated")
        ->allow_extra_args(false);
    command->add_option("--threads", a->run.threads, "default: all cores")->check(CLI::Range(1, 1024));
    command->add_flag("--census", a->census, "each again with every point audited: the true stress error");
    a->draw = [](const results::FinishedRun& run) {
        return report::draw_pictures(run.folder / "pictures", run);
    };
    command->callback([a, words, thresholds, &exit_code] {
        sort_words(*words, thresholds->count() > 0, *a);
        exit_code = study(*a);
    });
}

}  // namespace sandgraph::app

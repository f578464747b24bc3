#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>

#include "app/command_rve.hpp"
#include "base/console.hpp"
#include "io/atomic_file.hpp"
#include "io/folder_lock.hpp"
#include "laboratory/study_table.hpp"
#include "report/study_picture.hpp"

namespace sandgraph::app {
namespace {

struct Options {
    std::string out = "out/rve_study";
    int seeds = 3;
    bool quick = false;
    std::vector<std::string> histories;  // empty: all
};

// The packings of every seed: at the usual pressure, and at the low one.
struct Samples {
    std::vector<laboratory::StudySample> usual, low;
};

Samples make_samples(int seeds) {
    StageProgress progress;
    progress.update("packings", 0);
    Samples samples{std::vector<laboratory::StudySample>(seeds), std::vector<laboratory::StudySample>(seeds)};
    tbb::parallel_for(0, seeds, [&](int k) {
        scene::Grains grains;
        grains.seed = static_cast<std::uint64_t>(k) + 1;
        samples.usual[k] = laboratory::study_sample(grains, laboratory::study_pressure);
        samples.low[k] = laboratory::study_sample(grains, laboratory::study_pressure_low);
    });
    return samples;
}

// runs[setting][seed]; a run is one task of its own, so that its wall time holds nobody else's work.
std::vector<std::vector<laboratory::StudyRun>> run_all(
    const laboratory::StrainHistory& history, const std::vector<laboratory::StudySample>& samples,
    const std::vector<laboratory::StudySetting>& settings) {
    std::vector<std::vector<laboratory::StudyRun>> runs(settings.size(),
                                                        std::vector<laboratory::StudyRun>(samples.size()));
    StageProgress progress;
    const ProgressCallback telling = progress.callback();
    const std::size_t count = settings.size() * samples.size();
    Tally tally(count, telling);
    const auto one = [&](std::size_t job) {
        const std::size_t setting = job / samples.size(), seed = job % samples.size();
        tbb::this_task_arena::isolate([&] {
            runs[setting][seed] = laboratory::run_history(samples[seed], history, settings[setting].stepping);
        });
        tally.done(history.name);
    };
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1), [&](const auto& range) {
        for (std::size_t job = range.begin(); job < range.end(); ++job) one(job);
    });
    return runs;
}

bool chosen(const Options& options, const std::string& history) {
    return options.histories.empty() ||
           std::ranges::find(options.histories, history) != options.histories.end();
}

void run(const Options& options) {
    const std::filesystem::path folder = options.out;
    const io::FolderLock owner(folder);
    const int seeds = options.quick ? 1 : options.seeds;
    const Samples samples = make_samples(seeds);
    const std::vector<laboratory::StudySetting> settings = laboratory::study_settings(options.quick);
    std::vector<laboratory::StudyRow> rows;
    for (const laboratory::StrainHistory& history : laboratory::strain_histories(options.quick)) {
        if (!chosen(options, history.name)) continue;
        const auto& packings = history.pressure == laboratory::study_pressure ? samples.usual : samples.low;
        const auto more = laboratory::study_rows(history, settings, run_all(history, packings, settings));
        rows.insert(rows.end(), more.begin(), more.end());
        fmt::print("{}", laboratory::study_text(more));
        std::fflush(stdout);
    }
    io::write_text(folder / "study.csv", laboratory::study_csv(rows));
    const auto picture = report::draw_study_picture(report::study_picture(rows, seeds), folder / "study.png");
    fmt::print("\n{}\n", picture.drawn ? (folder / "study.csv").string() + ", study.png" : picture.message);
}

}  // namespace

void add_rve_study(CLI::App& rve) {
    CLI::App* study = rve.add_subcommand("study", "what each stepping rule of an RVE costs and errs");
    auto options = std::make_shared<Options>();
    study->add_option("-o,--out", options->out, "folder for study.csv and study.png")->capture_default_str();
    CLI::Option* seeds = study->add_option("--seeds", options->seeds, "packings of seeds 1 to N");
    seeds->check(CLI::Range(1, 1000))->capture_default_str();
    study->add_option("--history", options->histories, "only these of the histories")
        ->check(CLI::IsMember(
            {"quiet", "biaxial", "simple_shear", "reversal", "post_peak", "near_zero", "recontact"}));
    study->add_flag("--quick", options->quick, "one seed, shorter histories, fewer values")->excludes(seeds);
    study->callback([options] { run(*options); });
}

}  // namespace sandgraph::app

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "base/console.hpp"
#include "base/error.hpp"
#include "base/process.hpp"
#include "base/revision.hpp"
#include "io/atomic_file.hpp"
#include "io/folder_lock.hpp"
#include "io/history_file.hpp"
#include "scene/probe_spec.hpp"
#include "surrogate/load_surrogate.hpp"
#include "surrogate/model_file.hpp"
#include "training/card.hpp"
#include "training/evaluate.hpp"
#include "training/verdict.hpp"

namespace sandgraph::training {
namespace {

struct TrainCommand {
    std::string recipe, out;
    std::string probes;    // a log beside those of the recipe; "": none
    bool ladder = false;   // train and measure every rung, write the recipe's
    bool measure = false;  // train and measure, write no model: also for laws that cannot be served
    std::string evaluate;  // a model to measure on the held-out histories instead of training one; "": none
};

namespace fs = std::filesystem;
constexpr int done = 0, stopped = 3;
// Ten times finer increments then change the answer by 0.1 % at most (bench_surrogate_element).
constexpr double served_substep = 3.5e-5;

fs::path beside(const std::string& out, const std::string& ending) {
    return fs::path(out).replace_extension(ending);
}

void add_tables(const TrainingData& data, const Law& law, const std::string& of,
                std::vector<ErrorTable>& tables) {
    const auto add = [&](const char* name, const std::vector<Batch>& batches) {
        if (!batches.empty()) tables.push_back({of, name, error_rows(data.set, evaluate(law, batches))});
    };
    add("new seeds", data.new_seeds);
    add("known seeds", data.known_seeds);
    add("new seeds with p led", data.led_new_seeds);
    add("shipped probes", data.guard);
}

// Beside the model that training started from, on what neither was trained on here.
Verdict judge(const TrainingData& data, const Law& law, const std::string& start) {
    const std::shared_ptr<Law> before = law_of(start);
    Verdict out{start, "", {}};
    const auto compared = [&](const char* name, std::vector<Batch> batches) {
        if (batches.empty()) return Comparison{name};
        out.comparisons.push_back(compare(name, evaluate(*before, batches), evaluate(law, batches)));
        return out.comparisons.back();
    };
    std::vector<Batch> own = data.new_seeds;
    own.insert(own.end(), data.known_seeds.begin(), data.known_seeds.end());
    const Comparison held_out = compared("held out of the logs", own),
                     guard = compared("shipped probes", data.guard);
    out.words = verdict(held_out, guard, start);
    return out;
}

std::string text_of(const Verdict& verdict) {
    if (verdict.comparisons.empty()) return "trained from drawn weights: no model to compare with\n";
    std::string text;
    for (const Comparison& c : verdict.comparisons) text += comparison_text(c);
    return text + verdict.words + "\n";
}

void write_model(const scene::TrainSpec& spec, const TrainingData& data, const Law& law,
                 const std::string& out) {
    std::optional<surrogate::Model> model = law.served(served_substep);
    if (!model) return;
    model->data_hash = data.hash;
    model->description = fmt::format("{} from {}", name_of(spec.rung), spec.file);
    surrogate::write_model(out, *model);
    surrogate::load_surrogate(out);  // refuses what cannot be served
}

void check_servable(const scene::TrainSpec& spec) {
    if (spec.rung == Rung::mlp || spec.rung == Rung::gru)
        throw InputError({spec.file}, fmt::format("model.rung = \"{}\"", name_of(spec.rung)),
                         "the baselines cannot be served", "write rung = \"learned\", or give --measure");
    if (spec.traits != scene::TrainTraits::all)
        throw InputError({spec.file}, "model.traits is not \"all\"", "served points tell all their traits",
                         "write traits = \"all\", or give --measure");
}

// A model made before, on the histories that this recipe holds out.
int evaluate_only(const TrainingData& data, const std::string& file) {
    std::vector<ErrorTable> tables;
    add_tables(data, *law_of(file), name_of(Rung::learned), tables);
    tell(error_text(tables));
    return done;
}

// The log that was made for this recipe: between its making and now another training may have had the folder.
void check_probes(const scene::TrainSpec& spec, const std::string& log) {
    if (log.empty() || spec.probe.empty()) return;
    if (io::read_history_source(log).text == scene::read_probe(spec.probe).text) return;
    throw InputError({log}, "not the probes of this recipe",
                     "another training of the same name made them anew",
                     "give each model a name of its own with -o");
}

void write_results(const TrainCommand& command, const scene::TrainSpec& spec, const TrainingData& data,
                   const Trained& chosen, const std::vector<ErrorTable>& tables, const Verdict& verdict) {
    const std::string again = fmt::format("sandgraph train {} -o {}", command.recipe, command.out);
    io::write_text(beside(command.out, ".card.json"),
                   model_card(spec, data, chosen, tables, verdict, again, revision()));
    io::write_text(beside(command.out, ".errors.csv"), error_csv(tables));
    tell(fmt::format("{}\n{}: {} epochs, {:.0f} s\n{}", error_text(tables), command.out, chosen.epochs,
                     chosen.seconds, text_of(verdict)));
}

// Writes OUT, OUT's card and error table; answers the exit code: 0, or 3 when stopped and resumable.
int run(const TrainCommand& command) {
    const scene::TrainSpec spec = scene::read_train(command.recipe);
    if (!command.measure) check_servable(spec);
    catch_interrupts();
    std::optional<io::FolderLock> owner;
    if (!command.out.empty()) owner.emplace(scene::training_folder(command.out));
    check_probes(spec, command.probes);
    std::vector<std::string> logs = spec.logs;
    if (!command.probes.empty()) logs.push_back(command.probes);
    const TrainingData data = load_data(spec, logs);
    if (!command.evaluate.empty()) return evaluate_only(data, command.evaluate);
    notice(fmt::format("histories: {} train, {} validate, {} held out with their seeds, {} of known seeds",
                       data.split.training.size(), data.split.validation.size(), data.split.new_seeds.size(),
                       data.split.known_seeds.size()));
    std::vector<ErrorTable> tables;
    std::optional<Trained> chosen;
    for (const Rung rung : rungs) {
        if (!command.ladder && rung != spec.rung) continue;
        const auto trained =
            train(data, spec, rung, beside(command.out, fmt::format(".{}.state", name_of(rung))));
        if (!trained) return stopped;
        add_tables(data, *trained->law, name_of(rung), tables);
        if (rung == spec.rung) chosen = trained;
    }
    Verdict verdict;
    if (!spec.start.empty() && spec.rung == Rung::learned) {
        verdict = judge(data, *chosen->law, spec.start);
        add_tables(data, *law_of(spec.start), "start", tables);
    }
    const auto floor = noise_floor(data.set, data.rule, spec.strain_max);
    tables.insert(tables.end(), floor.begin(), floor.end());
    if (!command.measure) write_model(spec, data, *chosen->law, command.out);
    write_results(command, spec, data, *chosen, tables, verdict);
    for (const Rung rung : rungs) fs::remove(beside(command.out, fmt::format(".{}.state", name_of(rung))));
    return done;
}

}  // namespace
}  // namespace sandgraph::training

// Started by `sandgraph train`, which makes the probe log and hands the other arguments on.
int main(int argc, char** argv) {
    using namespace sandgraph;
    CLI::App app{"Trains a surrogate from history logs.", "sandgraph-train"};
    training::TrainCommand command;
    app.add_option("recipe", command.recipe, "TOML file")->required();
    app.add_option("-o,--out", command.out, "model to write, HDF5");
    app.add_option("--probes", command.probes, "history log made for the recipe");
    app.add_option("--evaluate", command.evaluate, "model to measure instead of training one");
    app.add_flag("--ladder", command.ladder, "trains and measures every rung");
    app.add_flag("--measure", command.measure, "writes no model, its errors alone");
    CLI11_PARSE(app, argc, argv);
    try {
        return training::run(command);
    } catch (const InputError& error) {
        notice(error.what());
        return 2;
    } catch (const std::exception& error) {
        notice(fmt::format("sandgraph-train: {}", error.what()));
        return 1;
    }
}

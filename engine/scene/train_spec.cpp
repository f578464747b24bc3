#include "scene/train_spec.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>

#include "scene/effects.hpp"
#include "scene/file_kind.hpp"
#include "scene/toml_file.hpp"

namespace sandgraph::scene {
namespace {

// Existing files, a list of names or one alone; looked up like an InputFile.
class InputFiles : public Value {
  public:
    explicit InputFiles(std::vector<std::string>& files) : files_(files) {}
    void read(const Entry& entry) override {
        files_.clear();
        if (const toml::array* list = entry.node.as_array())
            for (const toml::node& item : *list) read_one({item, entry.where, entry.name});
        else
            read_one(entry);
    }
    std::string shown() const override { return fmt::format("[{}]", fmt::join(files_, ", ")); }
    std::string canonical() const override { return shown(); }

  private:
    void read_one(const Entry& entry) {
        std::string name;
        InputFile(name).read(entry);
        files_.push_back(name);
    }
    std::vector<std::string>& files_;
};

void add_data_keys(KeyTable& keys, TrainSpec& spec) {
    auto data = keys.section("data");
    data.input_file("probe", spec.probe, "probe recipe: its history log is made first, beside the model");
    data.add("logs", std::make_unique<InputFiles>(spec.logs), "history logs of runs or probes");
    data.integer("held_out_seeds", spec.held_out_seeds, 0,
                 "highest packing seeds of probes, never trained on; of runs only if asked for");
    data.integer("validation_seeds", spec.validation_seeds, 0,
                 "packing seeds before those: they choose the best epoch; too few seeds: histories do");
    data.input_file("guard", spec.guard,
                    "log of probes that guard retraining against forgetting; default: table1.guard.h5 beside "
                    "model.start");
    data.integer("held_out_every", spec.held_out_every, 0,
                 "of the other seeds every so-manieth history is held out, too; 0: none");
    data.integer("histories", spec.histories, 0, "trained on at most, drawn evenly from the rest; 0: all");
    data.real("strain_max", spec.strain_max, "", above_up_to(0, 10), "length of a history that trains");
}

void add_step_keys(KeyTable& keys, TrainSpec& spec) {
    auto steps = keys.section("steps");
    steps.real("share", spec.steps.share, "", above_up_to(0, 1),
               "strain of a training step over that gone through since the start or the last turn");
    steps.real("least", spec.steps.least, "", above(0), "smallest strain of a training step");
    steps.real("most", spec.steps.most, "", above_up_to(0, 0.01), "largest strain of a training step");
    steps.real(
        "lead_from", spec.steps.lead_from, "", above(0),
        "path after which the measured pressure leads: where grains flow, p under given strain is chance");
    steps.real("lead_strain", spec.steps.lead_strain, "", at_least(0),
               "strain over which the error of p then decays by 1/e; 0: never");
}

void add_training_keys(KeyTable& keys, TrainSpec& spec) {
    auto training = keys.section("training");
    training.integer("seed", spec.training.seed, 0, "of initial weights, bootstrap and order");
    training.integer("epochs", spec.training.epochs, 1, "passes over the training histories at most");
    training.integer("patience", spec.training.patience, 1,
                     "passes without a better validation error, then it stops");
    training.integer("batch", spec.training.batch, 1, "histories side by side");
    training.integer("threads", spec.threads, 1, "of libtorch; the bits of the result depend on it");
    training.real("rate", spec.training.rate, "", above(0), "learning rate of Adam at the start");
    training.real("rate_end", spec.training.rate_end, "", above(0), "and at the end");
    training.real("clip", spec.training.clip, "", above(0), "largest norm of a member's gradient");
    training.flag("friction", spec.training.scale.friction,
                  "deviators count as shares of p: a low p is not made up for by friction");
    training.real("robust", spec.training.scale.robust, "", above(0),
                  "error, as a share of p, beyond which the loss grows linearly");
    training.real("change", spec.training.scale.change, "", at_least(0),
                  "while the stress has changed by less than this share of p, errors count as shares of it");
}

std::string guard_beside(const std::string& model) {
    const std::filesystem::path file = std::filesystem::path(model).parent_path() / "table1.guard.h5";
    return std::filesystem::exists(file) ? file.string() : "";
}

}  // namespace

KeyTable train_keys(TrainSpec& spec) {
    KeyTable keys;
    add_data_keys(keys, spec);
    auto model = keys.section("model");
    model.choice("rung", spec.rung, {"elastic", "fitted", "learned", "mlp", "gru"},
                 "elastic; elements with fitted constants; with learned coefficients; two baselines");
    model.integer("members", spec.members, 1, "of the ensemble");
    model.choice("traits", spec.traits, {"all", "stiffness", "none"},
                 "known of a packing beside p, n and stress: all; not Z, fabric, peak friction; nor K and G");
    model.flag("measured_critical", spec.measured_critical,
               "critical state as `sandgraph rve critical` measures it, not as training shifts it");
    model.input_file("start", spec.start, "model to go on from (retraining), else weights are drawn");
    add_training_keys(keys, spec);
    add_step_keys(keys, spec);
    return keys;
}

std::string training_folder(const std::string& out) {
    return std::filesystem::path(out).replace_extension(".training").string();
}

TrainSpec read_train(const std::string& file) {
    TrainSpec spec;
    spec.file = file;
    spec.text = read_text(file);
    KeyTable keys = train_keys(spec);
    const toml::table table = parse_toml(spec.text, file);
    require_kind(table, file, FileKind::train);
    keys.read(table, file);
    check_effects(keys, FileKind::train);
    if (spec.probe.empty() && spec.logs.empty())
        throw InputError({file, 0}, "nothing to train on", "there are neither logs nor a probe recipe",
                         "write logs = [\"FILE.h5\"] or probe = \"FILE.toml\" under [data]");
    spec.seeds_asked = keys.at("data.held_out_seeds").given || keys.at("data.validation_seeds").given;
    if (!spec.start.empty() && spec.guard.empty()) spec.guard = guard_beside(spec.start);
    return spec;
}

}  // namespace sandgraph::scene

#include "training/session.hpp"

#include <fmt/format.h>
#include <torch/types.h>
#include <torch/utils.h>

#include "base/console.hpp"
#include "base/hash.hpp"
#include "base/process.hpp"
#include "surrogate/model_file.hpp"
#include "training/baselines.hpp"
#include "training/split.hpp"

namespace sandgraph::training {
namespace {

constexpr auto number = torch::kFloat;

std::string data_hash(const scene::TrainSpec& spec, const HistorySet& set) {
    std::string text = spec.text;
    for (const std::string& source : set.sources) text += "\n" + source.substr(source.rfind(' '));
    if (!spec.start.empty()) text += "\nstart " + file_hash(spec.start);
    return hex(hash64(text));
}

void notice_epoch(Rung rung, const EpochReport& report) {
    notice(fmt::format("{} epoch {} of {}  loss {:.5f}  validation {:.5f}  best {:.5f}  {:.0f} s left",
                       name_of(rung), report.epoch, report.epochs, report.loss, report.validation,
                       report.best, report.seconds_left));
}

}  // namespace

TrainingData load_data(const scene::TrainSpec& spec, const std::vector<std::string>& logs) {
    TrainingData data;
    data.set = read_histories(logs, spec.guard);
    data.split = split(data.set, spec);
    withhold_traits(data.set, data.split.training, spec.traits);
    data.rule = spec.steps;
    data.hash = data_hash(spec, data.set);
    CutRule free = data.rule;
    free.lead_strain = 0;
    const auto batches = [&](const std::vector<std::int64_t>& which, const CutRule& rule, std::size_t size) {
        return make_batches(cut_all(data.set, which, rule, spec.strain_max), size, number);
    };
    data.training = batches(data.split.training, data.rule, static_cast<std::size_t>(spec.training.batch));
    data.validation = batches(data.split.validation, data.rule, 512);
    data.guard_validation = batches(data.split.guard_validation, data.rule, 512);
    data.guard = batches(data.split.guard, free, 512);
    data.new_seeds = batches(data.split.new_seeds, free, 512);
    data.known_seeds = batches(data.split.known_seeds, free, 512);
    data.led_new_seeds = batches(data.split.new_seeds, data.rule, 512);
    return data;
}

std::shared_ptr<Law> law_of(const std::string& file) {
    const surrogate::Model model = surrogate::read_model(file).model;
    std::shared_ptr<Law> law = make_law(Rung::learned, std::ssize(model.members), 1, number);
    law->start_from(model, file);
    return law;
}

std::optional<Trained> train(const TrainingData& data, const scene::TrainSpec& spec, Rung rung,
                             const std::filesystem::path& state) {
    const double start = wall_clock();
    torch::set_num_threads(spec.threads);
    Trained trained{.law = make_law(rung, spec.members, spec.training.seed, number)};
    const bool goes_on = rung == Rung::learned && !spec.start.empty();
    if (goes_on) {
        trained.law->start_from(surrogate::read_model(spec.start).model, spec.start);
        trained.law->learn_ranges(data.training);
    }
    if (spec.measured_critical) trained.law->hold_critical_state();
    Trainer trainer(trained.law, spec.training, std::ssize(data.set.histories), data.hash);
    if (trainer.load(state))
        notice(fmt::format("going on after epoch {}", trainer.epochs()));
    else if (goes_on)
        trainer.keep_start(data.validation, data.guard_validation);
    while (!trainer.done()) {
        const EpochReport report = trainer.epoch(data.training, data.validation, data.guard_validation);
        notice_epoch(rung, report);
        trainer.save(state);
        if (interrupted()) return {};
    }
    trainer.finish();
    trained.law->learn_ranges(data.training);
    trained.epochs = trainer.epochs();
    trained.validation = trainer.best();
    trained.seconds = wall_clock() - start;
    return trained;
}

}  // namespace sandgraph::training

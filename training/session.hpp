#pragma once
#include <filesystem>
#include <optional>

#include "scene/train_spec.hpp"
#include "training/split.hpp"
#include "training/trainer.hpp"

namespace sandgraph::training {

// The data of a recipe, cut and split.
struct TrainingData {
    HistorySet set;
    Split split;
    CutRule rule;
    std::vector<Batch> training, validation;
    std::vector<Batch> new_seeds, known_seeds;   // held out; rollouts know nothing but the strain
    std::vector<Batch> led_new_seeds;            // p led as in training
    std::vector<Batch> guard_validation, guard;  // of the shipped probes: led; knowing the strain alone
    std::string hash;  // of the logs' and the starting model's contents and of the recipe
};

// `logs`: the recipe's own and what was probed for it.
TrainingData load_data(const scene::TrainSpec& spec, const std::vector<std::string>& logs);

// The law of a model file, as trained.
std::shared_ptr<Law> law_of(const std::string& file);

struct Trained {
    std::shared_ptr<Law> law;
    int epochs = 0;
    double validation = 0, seconds = 0;  // best mean validation loss; wall time of this session
};

// Trains one rung with a progress line; goes on from `state` if that file belongs to the same data and
// recipe, and keeps it up to date every epoch. Empty when asked to stop.
std::optional<Trained> train(const TrainingData& data, const scene::TrainSpec& spec, Rung rung,
                             const std::filesystem::path& state);

}  // namespace sandgraph::training

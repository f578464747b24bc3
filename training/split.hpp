#pragma once
#include "scene/train_spec.hpp"
#include "training/history.hpp"

namespace sandgraph::training {

// Indices of histories. Whole packing seeds are kept apart, and of the seeds that are trained on, whole
// histories. Twins measure the noise floor and are in none.
struct Split {
    std::vector<std::int64_t> training, validation;
    std::vector<std::int64_t> new_seeds;    // held out with their seeds
    std::vector<std::int64_t> known_seeds;  // held out of seeds that are trained on
    std::vector<std::int64_t> seeds_validation, seeds_held_out;
};

// InputError when no seed is left to train on.
Split split(const HistorySet& set, const scene::TrainSpec& spec);

}  // namespace sandgraph::training

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

// Withholds from every law what `known` leaves out of the packings' traits: middle values stand in for them,
// for K and G a power law of the pressure through the packings that the histories `training` start from. What
// does a law owe to knowing its packing?
void withhold_traits(HistorySet& set, const std::vector<std::int64_t>& training, scene::TrainTraits known);

}  // namespace sandgraph::training

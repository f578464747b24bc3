#pragma once
#include "scene/train_spec.hpp"
#include "training/history.hpp"

namespace sandgraph::training {

// Indices of histories. Whole packing seeds of probes are kept apart, and of the seeds that are trained on,
// whole histories. The seed of a run is its user's ground and is trained on, unless there are runs alone and
// the recipe asks for seeds to hold out; where seeds do not suffice, histories stand in for them. Twins
// measure the noise floor and are in none.
struct Split {
    std::vector<std::int64_t> training, validation;
    std::vector<std::int64_t> new_seeds;    // held out with their seeds
    std::vector<std::int64_t> known_seeds;  // held out of seeds that are trained on
    std::vector<std::int64_t> guard_validation,
        guard;  // of the shipped probes: for choosing the epoch, measured
    std::vector<std::int64_t> seeds_validation, seeds_held_out;
};

// InputError when nothing is left to train on, or too few seeds for what the recipe asks.
Split split(const HistorySet& set, const scene::TrainSpec& spec);

// Withholds from every law what `known` leaves out of the packings' traits: middle values stand in for them,
// for K and G a power law of the pressure through the packings that the histories `training` start from. What
// does a law owe to knowing its packing?
void withhold_traits(HistorySet& set, const std::vector<std::int64_t>& training, scene::TrainTraits known);

}  // namespace sandgraph::training

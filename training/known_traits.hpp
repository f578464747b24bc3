#pragma once
#include "scene/train_spec.hpp"
#include "training/history.hpp"

namespace sandgraph::training {

// Withholds from every law what `known` leaves out of the packings' traits: middle values stand in for them,
// for K and G a power law of the pressure through the packings that the histories `training` start from. What
// does a law owe to knowing its packing?
void withhold_traits(HistorySet& set, const std::vector<std::int64_t>& training, scene::TrainTraits known);

}  // namespace sandgraph::training

#pragma once
#include <span>

#include "surrogate/model.hpp"
#include "training/element_law.hpp"

namespace sandgraph::training {

// Sets the law's feature ranges to what the batches show, measured and rolled out alike, but for one value in
// a thousand at either end.
void set_ranges(ElementLaw& law, std::span<const Batch> batches);

// The law as plain numbers for surrogate/; `substep` is the largest strain of its integration.
surrogate::Model export_model(const ElementLaw& law, double substep);

}  // namespace sandgraph::training

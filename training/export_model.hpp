#pragma once
#include <span>

#include "surrogate/model.hpp"
#include "training/element_law.hpp"

namespace sandgraph::training {

// Sets the law's feature ranges to what the batches show, measured and rolled out alike, but for one value in
// a thousand at either end.
void set_ranges(ElementLaw& law, std::span<const Batch> batches);

// Sets the law's parameters to those of a served model, to train on from. InputError when its shape differs
// (members, elements, hidden units); `file` is named in it.
void start_from(ElementLaw& law, const surrogate::Model& model, const std::string& file);

// The law as plain numbers for surrogate/; `substep` is the largest strain of its integration.
surrogate::Model export_model(const ElementLaw& law, double substep);

}  // namespace sandgraph::training

#pragma once
#include "scene/key_table.hpp"
#include "scene/scene.hpp"

namespace sandgraph::packings {

// What a packing file tells of its grains, put into `grains`: number and porosity, and the material of an
// .h5, which holds as it was prepared (a .csv has none, there the keys hold). Does nothing without
// grains.packing. InputError for a file that is no packing, and where a key of `given` says another material
// than the file's.
void take_packing_material(scene::Grains& grains, const scene::GivenKeys& given);

// In one line what `used` has otherwise than the packing; empty where they agree. An element test may ask
// what its packing would do with other contacts, but not without a word.
std::string changed_material(const dem::Material& used, const dem::Material& of_packing);

}  // namespace sandgraph::packings

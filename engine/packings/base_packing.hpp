#pragma once
#include <cstdint>
#include <string>

#include "base/console.hpp"
#include "io/packing_file.hpp"
#include "scene/scene.hpp"

// Base packings: what all packings of a ground or a laboratory are compressed from.
namespace sandgraph::packings {

// A packing from `file` (.csv or .h5). A CSV knows no material: Table 1's stands. Throws InputError,
// also for fewer grains than dem::fewest_grains.
io::PackingRecord load_packing(const std::string& file);

// Does this packing file know its material? An .h5 does.
bool has_material(const std::string& file);

// The base packing of `grains`: its packing file, or what its recipe makes; at rest.
dem::Packing base_packing(const scene::Grains& grains, const ProgressCallback& progress = {});

// The "dense" (n = 0.16) or "loose" (0.20) base packing of Table 1 sand by our own recipe, at 10 kPa, from
// the packing cache if it is there.
dem::Packing table1_packing(const std::string& density, std::uint64_t seed, int grains);

}  // namespace sandgraph::packings

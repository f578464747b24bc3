#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "scene/scene.hpp"

// A ground draws its points from `grains.samples` base packings of one recipe, so that the oddity of one does
// not act in step everywhere (DESIGN section 4).
namespace sandgraph::packings {

// Seed of base packing `sample`, 0 to samples - 1: the recipe's own for the first, so that one sample is the
// packing of the recipe; the others are drawn by it, so that the samples of seeds 1 and 2 have none in
// common.
std::uint64_t sample_seed(std::uint64_t seed, int sample);

// The recipe of that one base packing.
scene::Grains sample_recipe(const scene::Grains& grains, int sample);

// Which in-situ packing each point starts from, row * samples + sample, `row` by point. Points that follow
// each other in a row get every sample once before any comes again, in an order drawn by the seed: the shares
// of a row differ by one point at most, and a band meets all samples within a few points.
std::vector<std::int32_t> deal(std::span<const std::int32_t> row, const scene::Grains& grains);

}  // namespace sandgraph::packings

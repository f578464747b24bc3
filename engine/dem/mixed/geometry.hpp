#pragma once
#include <cstdint>

#include "base/tensor.hpp"
#include "dem/mixed/state.hpp"

// Where the grains and pairs of a mixed-precision packing are.
namespace sandgraph::dem {

// Periods to add to the second grain for the nearest image, and the branch in units of the cell.
struct NearestImage {
    std::int16_t cell_x, cell_y;
    std::int32_t x, y;
};
NearestImage nearest_image(const MixedPacking& packing, int i, int j);

// Calls visit(slot, i, j) for every listed pair.
template <class Visitor>
void for_each_pair(const MixedPacking& p, Visitor&& visit) {
    std::size_t slot = 0;
    const auto offer = [&](int i) {
        const int j = place_of(p.partner[slot]);
        if (i < p.grains && j < p.grains) visit(slot, i, j);
        ++slot;
    };
    for (std::size_t block = 0; block < p.rows.size(); ++block)
        for (int k = 0; k < MixedPacking::kLanes * p.rows[block]; ++k)
            offer(static_cast<int>(block) * MixedPacking::kLanes + k % MixedPacking::kLanes);
    for (const std::uint16_t place : p.loose_first) offer(place_of(place));
}

// Centre of a grain, wrapped into the cell [m].
Vec2 centre(const MixedPacking& packing, int grain);

// From a grain to the nearest image of another [m].
Vec2 branch(const MixedPacking& packing, const NearestImage& image);

}  // namespace sandgraph::dem

#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/tensor.hpp"
#include "dem/fast/aligned.hpp"

namespace sandgraph::dem {

struct GrainSet;

// A packing in the form of the mixed-precision kernel, at rest or in motion; N grains, padded to `room`, a
// multiple of kLanes with at least one padding grain. A coordinate is the share of a period in units of 2^-32
// and wraps by itself, so the difference of two is exact and that to the nearest image. Velocities are those
// relative to the mean field L x and, as the forces, floats.
// Pairs that touch stand in dealt rows: 16 grains make a block, each in a lane of its own; a block has `rows`
// rows, in each of which every lane has one pair (or none: the first padding grain is its partner). The
// others follow in loose rows of 16 pairs, sorted by gap: a row is looked at once `wear` has come up to it.
struct MixedPacking {
    static constexpr int kLanes = 16;

    int grains = 0, pairs = 0;
    Aligned<std::int32_t> x, y;          // [room]
    Aligned<float> x_rest, y_rest;       // [room] of the moves, what is less than a unit
    Aligned<float> u, v, w;              // [room] velocity less L x [m/s], spin [rad/s]
    std::vector<std::uint8_t> rows;      // [room/16]
    Aligned<std::uint16_t> partner;      // [slots] place (below) of the second grain; dealt rows, loose rows
    Aligned<float> tangential, moment;   // [slots] contact history [N], [N m]
    std::vector<float> loose_gap;        // [loose rows] least gap of its pairs as a share of their allowances
    Aligned<std::uint16_t> loose_first;  // [16 loose rows] place of the first grain

    Mat2 H = Mat2::Identity();  // cell
    Mat2 L = Mat2::Zero();      // velocity gradient of the last move [1/s]
    // The list holds while no grain has moved by more than its allowance beside the mean field: faster grains
    // have a larger one. `wear` bounds the share of it that any has used up since the search.
    double wear = 0;
    Aligned<float> inverse_allowance2;  // [room] [1/m2]; 0 for padding grains

    std::size_t room() const { return x.size(); }
    std::size_t bytes() const;
};

// The same with what a step needs besides; scratch memory of one thread.
struct MixedState {
    MixedPacking packing;
    double radius_max = 0;                                     // [m]
    Aligned<float> radius, inverse_mass, inverse_inertia;      // [room]; 0 for padding grains
    std::shared_ptr<const GrainSet> grains_of;                 // whose radii and masses these are, if a set's
    Aligned<float> record;                                     // [8 room] x, y, u, v, w, r, 0, 0 by place
    Aligned<float> on_second;                                  // [4 room] fx, fy, torque, 0 by place
    Aligned<float> fx_on_first, fy_on_first, torque_on_first;  // [room]
    Aligned<float> stiffness;                                  // [slots] k_n of the pairs [N/m],
    bool stiffness_known = false;                              // once a step has worked it out
};

// Where grain g lies in `record` and `on_second`: the transposed order in each block of 16, so that columns
// and rows turn into each other within quarters of a vector. Its own inverse.
constexpr int place_of(int g) { return g / 16 * 16 + g % 4 * 4 + g % 16 / 4; }

// Lanes for n grains and a padding grain.
constexpr std::size_t room_for(int n) {
    constexpr std::size_t kLanes = MixedPacking::kLanes;
    return (static_cast<std::size_t>(n) + kLanes) / kLanes * kLanes;
}

// A bound on the cell: nearest images are unique as long as its heights exceed twice the reach of a pair.
double least_height(double radius_max);

// Room for n grains; positions, velocities and radii are zero.
void resize_grains(MixedState& state, int n);

}  // namespace sandgraph::dem

#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/tensor.hpp"
#include "dem/fast/state.hpp"
#include "dem/mixed/list.hpp"
#include "dem/mixed/state.hpp"
#include "dem/packing/packing.hpp"

namespace sandgraph::dem {

// What never changes about the grains of a packing; shared by every RVE that was made from it.
struct GrainSet {
    std::vector<double> radius, inverse_mass, inverse_inertia;  // [N]
    double solid_area = 0;                                      // sum of pi r^2 [m2]
    double radius_max = 0, mean_diameter = 0;                   // [m]
};

// A packing at rest in memory, in the form of the kernel that drives it. For the double kernel: the working
// state without padding and without what GrainSet holds. Positions keep double precision (overlaps are a
// thousandth of a radius); velocities and contact history are rounded to float between two visits, a share of
// 6e-8 of themselves.
struct CompactPacking {
    std::shared_ptr<const GrainSet> grains;
    std::vector<double> position;           // [2 N] x, y of each grain
    std::vector<float> velocity;            // [3 N] vx, vy, spin of each grain
    std::vector<std::uint16_t> i, j;        // [slots] pairs, in the order of the pair loop
    std::vector<std::uint8_t> image;        // [slots]
    std::vector<float> tangential, moment;  // [slots]
    int pairs = 0, inner = 0;
    Mat2 H, L, H_force, LH;
    double approach = 0;
    std::optional<MixedPacking> mixed;  // instead of all of the above but `grains`, H and L, which both know
    Mat2 stress = Mat2::Zero();  // of the last force evaluation [Pa], compression positive, packing frame

    std::size_t bytes() const;
};

// Lists the near pairs of a packing at rest and takes its stress from `stress` (compression positive).
std::shared_ptr<const CompactPacking> compact(const Packing& packing, const Material& material,
                                              const Mat2& stress);

void unpack(const CompactPacking& packing, FastState& state);
void pack(const FastState& state, CompactPacking& packing);

// For the mixed kernel, whose form is taken up and laid down as it is, to the bit; a packing in the other
// form is converted. `pack` leaves that form behind.
void unpack(const CompactPacking& packing, MixedState& state, MixedList& list);
void pack(const MixedState& state, CompactPacking& packing);
// Whether the mixed kernel takes it: in a cell of few grains a pair is not with the nearest image alone.
bool fits_mixed(const CompactPacking& packing);
// A packing that many start from, converted once with its list: the form of each one's first visit, to the bit.
// As it is where it does not fit.
std::shared_ptr<const CompactPacking> in_mixed_form(std::shared_ptr<const CompactPacking> packing);
Packing to_packing(const CompactPacking& packing);

// Names a packing by its grains, pairs, contact history and cell.
std::int64_t content_hash(const CompactPacking& packing);

}  // namespace sandgraph::dem

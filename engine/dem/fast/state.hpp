#pragma once
#include <array>
#include <cstdint>
#include <memory>

#include "base/tensor.hpp"
#include "dem/fast/aligned.hpp"
#include "dem/material.hpp"

namespace sandgraph::dem {

struct GrainSet;

// Working state of the fast kernel for one packing. A grain is one record (x, y, vx, vy, r, r w, w, r), a
// cache line, so that a pair costs two loads and one subtraction of whole records.
struct FastState {
    static constexpr int kLanes = 8;   // arrays are padded to this many grains or pairs
    static constexpr int kRecord = 8;  // numbers a grain

    double radius_max = 0;                          // [m]
    int grains = 0;                                 // N
    Aligned<double> record;                         // [8 (N + pad)]
    Aligned<double> inverse_mass, inverse_inertia;  // [N + pad]; padding grains have 0
    std::shared_ptr<const GrainSet> masses_of;  // whose masses these are, if a packing at rest was taken up
    Aligned<double> force;                      // [4 (N + pad)]: fx, fy, and the torque in two parts

    double* grain(int g) { return &record[std::size_t{kRecord} * g]; }
    const double* grain(int g) const { return &record[std::size_t{kRecord} * g]; }

    int pairs = 0;                       // near pairs, padded to a multiple of kLanes
    int slots = 0;                       // padded number of pairs
    int inner = 0;                       // the first slots, whole lanes: pairs within the cell (image 4)
    Aligned<std::uint16_t> i, j;         // [slots]
    Aligned<std::uint8_t> image;         // [slots] 3 (cell_x + 1) + (cell_y + 1)
    Aligned<double> tangential, moment;  // [slots] contact history [N], [N m]

    Mat2 H = Mat2::Identity();        // cell now (moved together with the grains)
    Mat2 L = Mat2::Zero();            // velocity gradient of the last drift
    Mat2 H_force = Mat2::Identity();  // cell and L H_old at the last force evaluation
    Mat2 LH = Mat2::Zero();

    // Since the last neighbour search: bound on how much closer any two grains came [m].
    double approach = 0;
};

// Contact constants in the form the kernel wants.
struct KernelConstants {
    double young, stiffness_ratio, friction, rolling_stiffness, rolling_limit, damping;
    bool total_rolling;  // RollingForm::total
};
inline KernelConstants kernel_constants(const Material& m) {
    return {m.young,         m.stiffness_ratio, std::tan(m.friction_angle),          m.rolling_stiffness,
            m.rolling_limit, m.damping,         m.rolling_form == RollingForm::total};
}

}  // namespace sandgraph::dem

#pragma once
#include <Eigen/LU>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/tensor.hpp"
#include "dem/material.hpp"

namespace sandgraph::dem {

// A contact or near pair (i, j): the image of j in contact with i sits at x_j + H (cell_x, cell_y).
// n points from i to j; the tangent is e = (n_y, -n_x); the force on j is f_n n + tangential e, the moment on
// j is +moment. In 2D the tangential force is one number, turned with the contact by definition.
struct Contact {
    std::int32_t i = 0, j = 0;
    std::int16_t cell_x = 0, cell_y = 0;
    double tangential = 0;  // [N]
    double moment = 0;      // [N m]; total rolling form: the uncapped -k_r theta
};

// A periodic packing of disks at rest or in motion: everything needed to go on with the next DEM step.
struct Packing {
    Mat2 H = Mat2::Identity();         // columns are the periods [m]
    std::vector<double> x, y, r;       // centres (any image) and radii [m], size N
    std::vector<double> vx, vy, spin;  // velocities at the half step [m/s], [rad/s]; empty = at rest
    std::vector<Contact> contacts;     // history; pairs that are absent start at zero
    Mat2 L = Mat2::Zero();             // velocity gradient of the last step [1/s]

    std::size_t size() const { return x.size(); }
    double area() const { return H.determinant(); }
};

// 2D porosity 1 - sum(pi r^2)/A, overlaps counted twice.
double porosity(const Packing& packing);

// Grains pressed into each other by about half their radius: below this 2D porosity no contact law holds.
inline constexpr double crushed_porosity = -0.5;

// Largest radius over the smallest: time step and grid follow the smallest.
inline constexpr double widest_grading = 100;

// Where a packing came from, for error messages: the file, the line of the cell, the line of each grain.
struct PackingSource {
    std::string file;
    int cell_line = 0;
    std::span<const int> grain_lines;  // may be empty
};

// Refuses what no packing can be: not finite, r <= 0, a singular or inverted cell, a cell smaller than its
// grains, overlaps of more than half the smaller radius (over periodic images too). Throws InputError.
void check_packing(const Packing& packing, const PackingSource& source);

}  // namespace sandgraph::dem

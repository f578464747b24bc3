#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace sandgraph::graph {

// A Poisson sample of points with known, unequal chances: each point has a number of its own between 0 and 1
// that never changes, and is in the sample while that lies below its chance (permanent random numbers,
// Brewer, Early & Joyce 1972). Points are in or out independently of each other, so that sum of y/chance over
// the sample is an unbiased estimate of the sum of y over all (Horvitz & Thompson 1952) and its variance is
// known; and a sample that is drawn anew by other chances keeps as many of its points as it can.

// The chance of each point, for `expected` points in the mean: a share `evenly` of it alike for all, the rest
// in proportion to `size`; 1 at most. A size below zero is of a point that cannot be drawn: 0.
std::vector<double> chances(std::span<const double> size, double expected, double evenly);

std::vector<double> permanent_numbers(std::size_t points, std::uint64_t seed);

}  // namespace sandgraph::graph

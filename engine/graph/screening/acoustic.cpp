#include "graph/screening/acoustic.hpp"

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace sandgraph::graph {
namespace {

using Directions = std::array<Eigen::Matrix<double, 3, 2>, 36>;

// Strain of the velocity gradient g (x) n in Voigt form is N g; traction N^T s.
Directions directions() {
    Directions out;
    for (std::size_t k = 0; k < out.size(); ++k) {
        const double angle = std::numbers::pi * static_cast<double>(k) / static_cast<double>(out.size());
        const double x = std::cos(angle), y = std::sin(angle);
        out[k] << x, 0, 0, y, y, x;
    }
    return out;
}

}  // namespace

double least_acoustic_determinant(const Eigen::Matrix3d& tangent) {
    static const Directions all = directions();
    double least = std::numeric_limits<double>::infinity();
    for (const auto& N : all) {
        const Eigen::Matrix2d Q = N.transpose() * tangent * N;
        least = std::min(least, Q.determinant());
    }
    return least;
}

}  // namespace sandgraph::graph

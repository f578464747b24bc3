#pragma once
#include <Eigen/Core>

namespace sandgraph::graph {

// Least determinant of the acoustic tensor Q_jk = n_i C_ijkl n_l over 36 directions of n in the half plane:
// <= 0 where a shear band may form (Rudnicki & Rice 1975). `tangent` is d(stress)/d(strain) [Pa], rows and
// columns xx, yy, xy with the engineering shear strain; result [Pa2].
double least_acoustic_determinant(const Eigen::Matrix3d& tangent);

}  // namespace sandgraph::graph

#pragma once
#include "stress/surrogate.hpp"

namespace sandgraph::surrogate {

// d(stress)/d(strain) around the increment of size 1e-5 in the direction `strain`, by central differences of
// the law's own update (six updates in one batch). Zero direction: the mean of loading and unloading.
stress::Tangent difference_tangent(const stress::Surrogate& law, std::span<const double> state,
                                   const Eigen::Vector3d& strain);

}  // namespace sandgraph::surrogate

#pragma once
#include "base/tensor.hpp"
#include "stress/surrogate.hpp"
#include "surrogate/state_layout.hpp"

namespace sandgraph::surrogate {

// Point at rest under `initial`, every element loaded in proportion to its friction limit. InputError when
// the traits are no packing's or the mean stress is not positive.
PointState start_point(const Model& model, const stress::PackingTraits& traits, const Stress& initial);

// Drives the point through F_inc = R U: midpoint rule over equal substeps of U, then turned by R.
stress::SurrogateAnswer update_point(const Model& model, const Mat2& F_inc, PointState& point);

// d(stress)/d(strain) around the increment of size 1e-5 in the direction `strain`, by central differences of
// the law's own update (six updates in one batch). Zero direction: the mean of loading and unloading.
stress::Tangent difference_tangent(const stress::Surrogate& law, std::span<const double> state,
                                   const Eigen::Vector3d& strain);

}  // namespace sandgraph::surrogate

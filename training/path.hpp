#pragma once
#include <complex>
#include <vector>

#include "scene/train_spec.hpp"
#include "training/history.hpp"

namespace sandgraph::training {

using scene::CutRule;

// A history in the frame that turns with its packing, in the sign convention of surrogate/: compression
// positive, a deviator is the complex number (xx - yy)/2 + i xy.
struct Step {
    double dv = 0;               // volume compression
    std::complex<double> de;     // deviator of the strain increment
    double J = 1, J_middle = 1;  // volume ratio before the step and half way
    double strain = 0;           // length of the path behind the step, sum of |E|
    double p = 0;                // measured mean stress after the step [Pa]
    std::complex<double> s;      // measured deviator after it [Pa]
    double lead = 0;             // share of its error by which p is led to the measured one after the step
    double weight = 1;           // in the loss: flow is long and much the same
};

std::vector<Step> cut(const History& history, const CutRule& rule);

std::complex<double> deviator_of(const Stress& stress);  // compression positive

}  // namespace sandgraph::training

#pragma once
#include <complex>
#include <vector>

#include "training/history.hpp"

namespace sandgraph::training {

// How increments are composed to the steps a law is trained on: a step ends when its strain reaches `share`
// of the strain gone through since the start or the last turn, within [least, most].
struct CutRule {
    double least = 2e-5, most = 4e-4;
    double share = 0.06;
    // Past a path of `lead_from` the measured pressure leads: over a strain of `lead_strain` a rollout's
    // error of p decays by 1/e (fully so past twice that path). 0: never. Where grains flow, p under given
    // strain is weather (two packings part by several p), but q/p and dilation at a given p and void ratio
    // are climate.
    double lead_from = 0, lead_strain = 0;
};

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

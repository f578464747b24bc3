#pragma once
#include "base/tensor.hpp"
#include "graph/settings.hpp"
#include "stress/screening_log.hpp"

namespace sandgraph::graph {

using stress::Reason;

// What the gate looks at after an answer.
struct GateView {
    Mat2 F = Mat2::Identity();  // since the start
    Stress stress;              // answered [Pa], tension positive
    double peak_friction = 0;   // sin(phi) at the peak; 0: unknown
    double spread = 0, distance = 0;
    double work = 1;      // second-order work of the last increment, share of the elastic one
    double acoustic = 1;  // least determinant of the acoustic tensor, share of the elastic one
};

// How near to its threshold the worst measure is (1: at it), and which that is.
struct Verdict {
    double level = 0;
    Reason reason = Reason::none;
};
Verdict judge(const GateView& view, const GateSettings& settings);

// |ln l1 - ln l2| of the principal stretches of F.
double deviatoric_strain(const Mat2& F);

}  // namespace sandgraph::graph

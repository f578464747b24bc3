#pragma once
#include <cstdint>

#include "dem/rve_options.hpp"

namespace sandgraph::graph {

// Settings of the laws, with their only defaults: the scene's keys of the same names bind to these members.

// What a point's stress follows between two answers of its law: its small-strain stiffness, or that less the
// shortfall that the last answers showed along the way the point is going.
enum class Predictor { elastic, secant };

// How true the stress between two answers of a point's law shall be.
struct VisitSettings {
    double update_tolerance = 0.005;  // error aimed at of the predicted stress, share of p
    double update_change_max = 0.2;   // largest predicted stress change between two answers, share of p
    Predictor predictor = Predictor::secant;
};

// [rve]: how a packing follows its point, and how often it is asked.
struct RveSettings : dem::RveStepping, VisitSettings {};

// [gate]: where a surrogate must not be trusted. A point is handed over where a measure passes its threshold.
struct GateSettings {
    bool active = true;               // false: only failed answers are handed over
    double strain = 0.003;            // deviatoric strain since the start, |ln l1 - ln l2|
    double stress_ratio = 1;          // q/p, as a share of the packing's peak sin(phi)
    double tension = 100;             // p below it [Pa]
    double distance = 0.25;           // of a feature outside the trained range, in widths of that range
    double spread = 0.5;              // of the ensemble, share of p
    double second_order_work = -0.1;  // of an increment below it, share of the elastic one
    double acoustic = -1000;          // det of the acoustic tensor below it, share of the elastic one
    double acoustic_from = 0.9;       // q/p from which the acoustic tensor is looked at, share of sin(phi)
    double low = 0.5;                 // share of a threshold from which the packing is made ready
    double flow = 0.1;                // deviatoric strain from which the surrogate answers again; 0: never
};

// [gate], too: how a point is handed to its grains.
struct HandOverSettings {
    int dilate = 1;            // cells around a point past the gate that are handed over with it
    int blend_steps = 200;     // steps over which the jump fades
    int replay_steps = 50;     // DEM steps a packing catches up by at each step
    double path_error = 0.02;  // of the recorded strain path, as an elastic stress, share of p
};

// [audit]: how a screening run measures its own error.
struct AuditSettings {
    double share = 0.01;  // of the points, drawn at random
    std::uint64_t seed = 1;
    double every = 0.01;  // d/B between two audits
    // Auditors of the load: how many are expected, and which share of them is drawn evenly, not by power.
    int load_points = 20;  // 0: none
    double load_evenly = 0.25;
};

// All of a screening law's settings but those of its grains.
struct ScreeningSettings {
    // [surrogate]: of the surrogate, not of the grains.
    VisitSettings visits{
        .update_tolerance = 0.01, .update_change_max = 0.05, .predictor = Predictor::elastic};
    GateSettings gate;
    HandOverSettings hand_over;
    AuditSettings audit;
};

}  // namespace sandgraph::graph

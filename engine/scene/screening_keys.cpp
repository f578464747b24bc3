#include "scene/screening_keys.hpp"

namespace sandgraph::scene {
namespace {

void add_surrogate_keys(KeyTable& keys, Screening& s, bool in_use) {
    auto surrogate = keys.section("surrogate");
    // The hash takes the file's contents, not its name.
    surrogate.input_file("model", s.model, "trained weights (.h5); default: the shipped table1.surrogate.h5")
        .in_hash = false;
    surrogate
        .real("update_tolerance", s.visits.update_tolerance, "", at_least(0),
              "error aimed at of the stress predicted between answers, share of p")
        .in_hash = in_use;
    surrogate
        .real("update_change_max", s.visits.update_change_max, "", at_least(0),
              "largest predicted stress change between answers, share of p")
        .in_hash = in_use;
}

void add_gate_keys(KeyTable& keys, graph::GateSettings& g, graph::HandOverSettings& h, bool in_use) {
    auto gate = keys.section("gate");
    const auto real = [&](const char* name, double& value, const char* unit, Range range, const char* text) {
        gate.real(name, value, unit, range, text).in_hash = in_use;
    };
    const auto whole = [&](const char* name, int& value, std::int64_t low, const char* text) {
        gate.integer(name, value, low, text).in_hash = in_use;
    };
    gate.flag("active", g.active, "false: the surrogate everywhere, save where its answers fail").in_hash =
        in_use;
    real("strain", g.strain, "", at_least(0),
         "deviatoric strain |ln l1 - ln l2| since the start; 0: grains everywhere");
    real("stress_ratio", g.stress_ratio, "", above(0), "q/p, as a share of the packing's peak sin(phi)");
    real("tension", g.tension, "Pa", at_least(0), "mean stress below it; 0: off");
    real("distance", g.distance, "", above(0),
         "of a feature outside the trained range, in widths of that range");
    real("spread", g.spread, "", above(0), "of the ensemble, share of p");
    real("second_order_work", g.second_order_work, "", {.high = 0.99},
         "of an increment below it, share of the elastic one; -1000: off");
    real("acoustic", g.acoustic, "", {.high = 0.99},
         "least det of the acoustic tensor below it, share of the elastic one; -1000: off");
    real("acoustic_from", g.acoustic_from, "", at_least(0),
         "q/p from which the acoustic tensor is looked at, share of sin(phi)");
    real("low", g.low, "", above_up_to(0, 1), "share of a threshold from which the packing is made ready");
    real("flow", g.flow, "", at_least(0),
         "deviatoric strain past which sand flows and the surrogate answers again; 0: never, grains to the "
         "end");
    whole("dilate", h.dilate, 0, "cells around a point past the gate that are handed over with it");
    whole("blend_steps", h.blend_steps, 1, "steps over which the stress jump of a hand-over fades");
    whole("replay_steps", h.replay_steps, 1, "DEM steps by which a packing catches up at each step");
    real("path_error", h.path_error, "", above(0),
         "of the recorded strain path, as an elastic stress, share of p");
}

void add_audit_keys(KeyTable& keys, graph::AuditSettings& a, bool in_use) {
    auto audit = keys.section("audit");
    // No audit changes what the ground does, but the checkpoint must hold the same packings.
    audit
        .real("share", a.share, "", within(0, 1),
              "of the points, that carry a second packing to measure the error")
        .in_hash = in_use;
    audit.integer("seed", a.seed, 0, "of the draw").in_hash = in_use;
    audit.real("every", a.every, "", at_least(1e-6), "d/B between two audits").in_hash = in_use;
    audit
        .integer("load_points", a.load_points, 0,
                 "expected number of points whose packings measure the load's error; 0: none")
        .in_hash = in_use;
    audit
        .real("load_evenly", a.load_evenly, "", above_up_to(0, 1),
              "share of them drawn evenly, the rest by the power that their points take")
        .in_hash = in_use;
}

}  // namespace

void add_screening_keys(KeyTable& keys, Screening& screening, bool in_use) {
    add_surrogate_keys(keys, screening, in_use);
    add_gate_keys(keys, screening.gate, screening.hand_over, in_use);
    add_audit_keys(keys, screening.audit, in_use);
}

}  // namespace sandgraph::scene

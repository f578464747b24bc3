#include "laboratory/study_setting.hpp"

namespace sandgraph::laboratory {
namespace {

using graph::RveSettings;

struct Axis {
    const char* key;
    void (*set)(RveSettings&, double);
    std::vector<double> near, far;  // values beside the default, and further ones
};

std::vector<Axis> axes() {
    return {
        {"inertial_number_max",
         [](RveSettings& s, double v) { s.inertial_number_max = v; },
         {1e-3, 4e-3},
         {5e-4, 8e-3}},
        {"strain_per_step_max",
         [](RveSettings& s, double v) { s.strain_per_step_max = v; },
         {5e-6, 2e-5},
         {2.5e-6, 4e-5}},
        {"update_tolerance",
         [](RveSettings& s, double v) { s.update_tolerance = v; },
         {0.0025, 0.01},
         {0, 0.00125}},
        {"update_change_max",
         [](RveSettings& s, double v) { s.update_change_max = v; },
         {0.1, 0.4},
         {0.05, 0.025}},
        {"steps_min", [](RveSettings& s, double v) { s.steps_min = static_cast<int>(v); }, {1, 5}, {10, 20}},
        {"stress_per_step_max",
         [](RveSettings& s, double v) { s.stress_per_step_max = v; },
         {0.0075, 0.03},
         {0.005, 1e6}},
        {"time_step_fraction",
         [](RveSettings& s, double v) { s.time_step_fraction = v; },
         {0.4, 1},
         {0.1, 0.2, 0.6}},
        {"pressure_floor", [](RveSettings& s, double v) { s.pressure_floor = v; }, {300, 3000}, {100, 30}}};
}

void vary(const Axis& axis, const std::vector<double>& values, std::vector<StudySetting>& out) {
    for (const double value : values) {
        out.push_back({axis.key, value, {}});
        axis.set(out.back().stepping, value);
    }
}

// Several keys moved together. 1: tolerance and inertial number halved; 2: both a quarter; 3: both a quarter
// and half the strain a step.
std::vector<StudySetting> tighter() {
    std::vector<StudySetting> out;
    const auto add = [&](double tolerance, double inertial, double strain) {
        out.push_back({"tighter", static_cast<double>(out.size() + 1), {}});
        graph::RveSettings& s = out.back().stepping;
        s.update_tolerance = tolerance, s.inertial_number_max = inertial, s.strain_per_step_max = strain;
    };
    add(0.0025, 1e-3, 1e-5);
    add(0.00125, 5e-4, 1e-5);
    add(0.00125, 5e-4, 5e-6);
    return out;
}

}  // namespace

RveSettings reference_stepping() {
    RveSettings s;
    s.update_tolerance = 0, s.strain_per_step_max = 1e-6, s.inertial_number_max = 2e-4;
    s.time_step_fraction = 0.2;
    return s;
}

RveSettings twin_stepping() {
    RveSettings s = reference_stepping();
    s.strain_per_step_max = 1.5e-6, s.inertial_number_max = 3e-4;
    return s;
}

RveSettings peers_stepping() {
    constexpr double no_limit = 1e6;
    RveSettings s;
    s.update_tolerance = 0, s.strain_per_step_max = 1e-5, s.inertial_number_max = no_limit;
    s.stress_per_step_max = no_limit;
    s.steps_min = 2;
    return s;
}

std::vector<StudySetting> study_settings(bool quick) {
    std::vector<StudySetting> out{{"reference", 0, reference_stepping()},
                                  {"twin", 0, twin_stepping()},
                                  {"peers", 0, peers_stepping()},
                                  {"default", 0, {}}};
    for (const Axis& axis : axes()) {
        vary(axis, axis.near, out);
        if (!quick) vary(axis, axis.far, out);
    }
    const std::vector<StudySetting> together = tighter();
    out.insert(out.end(), together.begin(), together.end());
    return out;
}

}  // namespace sandgraph::laboratory

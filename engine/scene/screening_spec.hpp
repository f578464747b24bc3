#pragma once
#include <cstdint>
#include <string>

namespace sandgraph::scene {

// The learned stress law of a screening run.
struct SurrogateChoice {
    std::string model;  // weights file; "": the one shipped for the paper's packings
    double update_tolerance = 0.01, update_change_max = 0.05;  // as those of [rve]
};

// From where on the surrogate is not trusted, and how a point is handed to its grains.
struct Gate {
    bool active = true;
    double strain = 0.003;
    double stress_ratio = 1;
    double tension = 100;  // [Pa]
    double distance = 0.25;
    double spread = 0.5;
    double second_order_work = -0.1;
    double acoustic = -1000, acoustic_from = 0.9;
    double low = 0.5;
    double flow = 0.1;
    int dilate = 1;
    int blend_steps = 200, replay_steps = 50;
    double path_error = 0.02;
};

// How a screening run measures its own error.
struct Audit {
    double share = 0.01;
    std::uint64_t seed = 1;
    double every = 0.01;  // d/B
};

struct Screening {
    SurrogateChoice surrogate;
    Gate gate;
    Audit audit;
};

}  // namespace sandgraph::scene

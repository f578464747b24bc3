#pragma once
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace sandgraph::laboratory {

// One way to step an RVE: the default with one key changed, or a rule of its own.
struct StudySetting {
    std::string key;   // the key that differs; "default", "peers", "reference", "twin" or "tighter"
    double value = 0;  // of that key
    graph::RveSettings stepping;
};

inline constexpr std::size_t study_reference = 0, study_twin = 1, study_peers = 2, study_default = 3;

// Fixed and fine: every increment is driven, at a tenth of the default inertial number and half its DEM step.
graph::RveSettings reference_stepping();
// Nearly as fine: how far it is from the reference is how far two right answers are apart.
graph::RveSettings twin_stepping();
// YADE driver of the FEM x DEM literature: max(1e5 |strain|, 2) DEM steps each load step, none skipped.
graph::RveSettings peers_stepping();

// The four above in the order of their indices, then every key varied up and down (quick: one value
// each way), then several keys moved together.
std::vector<StudySetting> study_settings(bool quick);

}  // namespace sandgraph::laboratory

#pragma once
#include <fmt/format.h>

#include <string>

namespace sandgraph::support {

// A plate in Mohr-Coulomb sand of 30 deg, as a scene file says it; lengths [m].
struct SandScene {
    double width = 3, depth = 4, cell = 0.125;  // of the domain
    double plate = 1, thickness = 0.125, embedment_ratio = 2, pull_to = 0.05;
    double gravity = 9.81;  // [m/s2]
    double young = 40;      // [MPa]
};

inline std::string sand_scene(const SandScene& s = {}) {
    return fmt::format(R"(
[domain]
width = "{} m"
depth = "{} m"
cell = "{} m"
[anchor]
width = "{} m"
thickness = "{} m"
embedment_ratio = {}
pull_to = {}
[ground]
law = "mohr_coulomb"
gravity = "{} m/s2"
[continuum]
young = "{} MPa"
friction_angle = "30 deg"
)",
                       s.width, s.depth, s.cell, s.plate, s.thickness, s.embedment_ratio, s.pull_to,
                       s.gravity, s.young);
}

}  // namespace sandgraph::support

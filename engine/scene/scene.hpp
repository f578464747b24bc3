#pragma once
#include <cstdint>
#include <map>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "dem/material.hpp"
#include "dem/prepare/recipe.hpp"
#include "graph/settings.hpp"
#include "mpm/time_step.hpp"
#include "scene/body_spec.hpp"
#include "scene/region_spec.hpp"
#include "stress/constants.hpp"

namespace sandgraph::scene {

// A checked scene in SI units. The TOML keys have the same names. Where a setting belongs to a part of the
// engine, the struct here is that part's own: its default stands there and nowhere else.
enum class Law { rve, elastic, mohr_coulomb };
enum class Orientation { horizontal, vertical };  // of the plate; pulled along its normal (up / to +x)
enum class Mode { full, screening };
// Where the grid's nodes stand beside the ends of a plate's faces: midway about them, so that the plate is as
// wide as it is, or on them, as in the paper, which makes it wider by a cell.
enum class Edges { between_nodes, on_nodes };
// What an exact limit load is known of (results/exact.hpp).
enum class ExactCase {
    none,
    anchor,
    anchor_vertical,
    footing,
    footing_surcharge,
    wall_passive,
    wall_active,
    trapdoor
};
enum class PictureFormat { png, svg, pdf };

struct Domain {
    double width = 6;   // [m]; of the half model when the anchor is horizontal (symmetry plane at x = 0)
    double depth = 5;   // ground surface is y = depth, fixed base y = 0 [m]
    double cell = 0.1;  // [m]
    int points_per_cell = 1;  // 1, 4 or 9
    Edges edges = Edges::between_nodes;
};

struct Anchor {
    bool present = true;
    Orientation orientation = Orientation::horizontal;
    double width = 1;        // B [m]
    double thickness = 0.1;  // [m]
    double embedment_ratio =
        3;                    // H/B; H: surface to the top face (horizontal) or to the lower edge (vertical)
    double position = 0;      // x of the plate's centre [m]; horizontal: 0 (symmetry plane); vertical: free
    double pull_rate = 0.05;  // [m/s]; unless given default_pull_rate (expected_ground.hpp)
    double ramp = 0.01;       // d/B over which the rate rises smoothly from zero
    double pull_to = 0.4;     // d_max / B
    double friction_angle = std::numbers::pi / 2;  // plate-soil friction [rad]; 90 deg = perfectly rough
};

// [grains] (law = "rve"): the recipe of the base packing, its material, and what stands instead of a recipe.
struct Grains : dem::Recipe {
    dem::Material material;
    std::string density = "dense";  // "dense" (porosity 0.16), "loose" (0.20) or "custom"
    std::string packing;            // file (.csv or .h5) to start from instead of the recipe; "" = recipe
    int samples = 1;                // base packings that a ground draws its points from
};

// Closed-form laws (law = "elastic" | "mohr_coulomb").
struct Continuum : stress::MohrCoulombConstants {
    double density = 2200;  // bulk [kg/m3]
};

struct Ground {
    Law law = Law::rve;
    double surcharge = 0;  // on the free surface [Pa]
    double k0 = 1;         // at rest, horizontal stress (along x and out of the plane) over vertical stress
    double gravity = 9.81;
    double internal_length = 0;  // of shear bands [m]; 0: they are as wide as cells make them
    Grains grains;
    graph::RveSettings rve;
    Continuum continuum;
};

struct Screening : graph::ScreeningSettings {
    std::string model;  // the surrogate's weights file; "": the one shipped for the paper's packings
};

struct Mpm : mpm::Scheme {
    double end_time = 1;  // when ground without an anchor has run long enough [s]
};

struct Output {
    std::string folder;  // default: out/<scene file stem>
    bool pictures = false;
    PictureFormat picture_format = PictureFormat::png;           // svg, pdf: beside the PNG
    double load_every = 0.0005;                                  // in d/B
    std::vector<double> frames = {0, 0.02, 0.1, 0.2, 0.3, 0.4};  // in d/B
    double checkpoint_every = 120;                               // wall time [s]
    bool history = false;                                        // RVE history log (off unless asked for)
    int history_points = 64;                                     // of the ground, in the log
    double history_max = 500e6;                                  // size at which logging ends [B]
};

struct Scene {
    std::string title, file;  // file: the path it was read from
    std::string text;         // the TOML text with overrides applied, stored in run.h5
    Mode mode = Mode::full;
    Domain domain;
    Anchor anchor;
    Ground ground;
    Mpm mpm;
    Screening screening;
    Output output;
    std::vector<Region> regions;
    std::vector<Body> bodies;  // beside the anchor
    ExactCase exact = ExactCase::none;
    std::map<std::string, InputError::Where, std::less<>> given;  // "section.key" that the scene sets: where
    // The body whose load is told where there is no anchor: the first that moves; null: none does.
    const Body* loaded_body() const {
        for (const Body& body : bodies)
            if (body.moves() && !anchor.present) return &body;
        return nullptr;
    }
    bool loaded() const { return anchor.present || loaded_body() != nullptr; }
    InputError::Where where(std::string_view key) const {
        const auto it = given.find(key);
        return it != given.end() ? it->second : InputError::Where{file, 0};
    }
};

}  // namespace sandgraph::scene

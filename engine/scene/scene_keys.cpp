#include "scene/scene_keys.hpp"

#include <numbers>

#include "scene/body_tables.hpp"
#include "scene/grain_keys.hpp"
#include "scene/region_tables.hpp"
#include "scene/screening_keys.hpp"

namespace sandgraph::scene {
namespace {

constexpr double right_angle = std::numbers::pi / 2;

void add_top_keys(KeyTable& keys, Scene& scene) {
    auto top = keys.section("");
    top.text("title", scene.title, "shown in reports").in_hash = false;
    top.choice("mode", scene.mode, {"full", "screening"},
               "every point a packing, or the surrogate where it is safe");
    top.add("region", std::make_unique<RegionTables>(scene.regions), "parts of the ground to follow by name")
        .in_hash = false;
    top.add("body", std::make_unique<BodyTables>(scene.bodies),
            "rigid bodies beside or instead of the anchor");
    top.choice("exact", scene.exact,
               {"none", "anchor", "anchor_vertical", "footing", "footing_surcharge", "wall_passive",
                "wall_active", "trapdoor"},
               "known limit load to compare with")
        .in_hash = false;
}

void add_domain_keys(KeyTable& keys, Domain& d) {
    auto domain = keys.section("domain");
    domain.real("width", d.width, "m", above(0),
                "of the model; half of it for a horizontal plate (symmetry)");
    domain.real("depth", d.depth, "m", above(0), "from the fixed base to the surface");
    domain.real("cell", d.cell, "m", above(0), "grid cell; width and depth are multiples of it");
    domain.integer("points_per_cell", d.points_per_cell, 1, "material points in a cell", {1, 4, 9});
    domain.choice(
        "edges", d.edges, {"between_nodes", "on_nodes"},
        "grid nodes midway about the ends of a plate's faces, or on them (a cell too wide, as in the paper)");
}

void add_anchor_keys(KeyTable& keys, Anchor& a) {
    auto anchor = keys.section("anchor");
    anchor.flag("present", a.present, "false: ground under its own weight only, run to mpm.end_time");
    anchor.choice("orientation", a.orientation, {"horizontal", "vertical"}, "pulled up, or sideways to +x");
    anchor.real("width", a.width, "m", above(0), "B");
    anchor.real("thickness", a.thickness, "m", above(0), "of the plate");
    anchor.real("embedment_ratio", a.embedment_ratio, "", above(0),
                "H/B; H from the surface to the top face (horizontal) or the lower edge (vertical)");
    anchor.real("position", a.position, "m", at_least(0),
                "x of the plate's centre; vertical: middle of the domain unless given");
    anchor.real("pull_rate", a.pull_rate, "m/s", above(0),
                "speed of the plate; unless given this or less, so that inertia carries no load");
    anchor.real("ramp", a.ramp, "", at_least(0), "d/B over which the speed rises from zero");
    anchor.real("pull_to", a.pull_to, "", above(0), "d/B at the end");
    anchor.real("friction_angle", a.friction_angle, "deg", within(0, right_angle),
                "plate against soil; 90 deg is perfectly rough");
}

void add_ground_keys(KeyTable& keys, Ground& g) {
    auto ground = keys.section("ground");
    ground.choice("law", g.law, {"rve", "elastic", "mohr_coulomb"}, "what answers a strain with a stress");
    ground.real("surcharge", g.surcharge, "kPa", within(0, 1e8), "on the free surface");
    ground.real("gravity", g.gravity, "m/s2", at_least(0), "downwards");
    // Isotropic ground has the hash of the time before this key.
    ground.real("k0", g.k0, "", above(0), "horizontal over vertical stress of the ground at rest").in_hash =
        g.k0 != 1;
    // Local ground has the hash of the time before this key.
    ground
        .real("internal_length", g.internal_length, "m", at_least(0),
              "length over which strength is shared, bands 1.2 to 1.6 times as wide; 3 cells or more; 0: as "
              "narrow as cells")
        .in_hash = g.internal_length > 0;
}

// Of grounds only: a recipe is one packing. One sample has the hash of the time before this key.
void add_sample_key(KeyTable& keys, Grains& g) {
    auto grains = keys.section("grains");
    grains
        .integer(
            "samples", g.samples, 1,
            "base packings of this recipe that the ground draws its points from, dealt evenly by the seed")
        .in_hash = g.samples > 1;
}

void add_continuum_keys(KeyTable& keys, Continuum& c) {
    auto law = keys.section("continuum");
    law.real("young", c.young, "MPa", above(0), "Young's modulus of the closed-form laws");
    law.real("poisson", c.poisson, "", within(0, 0.49), "Poisson's ratio");
    law.real("friction_angle", c.friction_angle, "deg", within(0, right_angle), "of mohr_coulomb");
    law.real("dilation_angle", c.dilation_angle, "deg", within(0, right_angle), "of mohr_coulomb");
    law.real("cohesion", c.cohesion, "kPa", at_least(0), "of mohr_coulomb");
    law.real("density", c.density, "kg/m3", above(0), "bulk density");
}

void add_mpm_keys(KeyTable& keys, Mpm& m) {
    auto mpm = keys.section("mpm");
    mpm.real("courant", m.courant, "", above_up_to(0, 1),
             "time step times c/cell, c: P-wave speed; at most 0.45/sqrt(1 + contact_stiffness) is taken");
    mpm.real("damping", m.damping, "", within(0, 0.9), "local grid damping");
    mpm.real(
        "pic_fraction", m.pic_fraction, "", within(0, 1),
        "PIC share of the velocity update in a step of courant 0.3, less in a shorter one; the rest FLIP");
    mpm.real("mass_scaling", m.mass_scaling, "", at_least(1), "inertia multiplied by this, gravity kept");
    mpm.real("contact_stiffness", m.contact_stiffness, "", above(0),
             "plate on soil, in P-wave moduli a cell");
    mpm.real("hourglass", m.hourglass, "", above_up_to(0, 1),
             "share that a point keeps of what its strain differs from its cell's mean; 1: full integration");
    mpm.flag("light_nodes", m.light_nodes, "nodes with next to no mass follow their neighbours");
    mpm.real("end_time", m.end_time, "s", above(0), "end of a run without an anchor (a pull ends at pull_to)")
        .in_hash = false;
}

// Nothing here changes the physics, so nothing here is in the scene's hash.
void add_output_keys(KeyTable& keys, Output& o) {
    auto output = keys.section("output");
    output.text("folder", o.folder, "empty: out/<name of the scene file>").in_hash = false;
    output.flag("pictures", o.pictures, "PNG pictures of every frame").in_hash = false;
    output
        .choice("picture_format", o.picture_format, {"png", "svg", "pdf"},
                "of the pictures: PNG alone, or SVG or PDF beside it")
        .in_hash = false;
    output
        .real("load_every", o.load_every, "", at_least(1e-6),
              "d/B between rows of load.csv; without an anchor s")
        .in_hash = false;
    output
        .add("frames", std::make_unique<RisingReals>(o.frames, at_least(0)),
             "d/B of the field frames; without an anchor s")
        .in_hash = false;
    output.real("checkpoint_every", o.checkpoint_every, "s", above(0), "wall time between checkpoints")
        .in_hash = false;
    output
        .flag("history", o.history,
              "log the updates of some packings (screening: the audited ones) to history.h5, for training")
        .in_hash = false;
    output
        .integer("history_points", o.history_points, 1,
                 "points in the log: half anywhere, half near the plate and its edges")
        .in_hash = false;
    output.real("history_max", o.history_max, "MB", above(0), "size at which logging ends").in_hash = false;
}

}  // namespace

KeyTable scene_keys(Scene& scene) {
    KeyTable keys;
    add_top_keys(keys, scene);
    add_domain_keys(keys, scene.domain);
    add_anchor_keys(keys, scene.anchor);
    add_ground_keys(keys, scene.ground);
    add_grain_keys(keys, scene.ground.grains);
    add_sample_key(keys, scene.ground.grains);
    add_stepping_keys(keys, scene.ground.rve);
    add_continuum_keys(keys, scene.ground.continuum);
    add_mpm_keys(keys, scene.mpm);
    add_screening_keys(keys, scene.screening, scene.mode == Mode::screening);
    add_output_keys(keys, scene.output);
    return keys;
}

}  // namespace sandgraph::scene

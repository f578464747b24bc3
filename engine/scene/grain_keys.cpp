#include "scene/grain_keys.hpp"

#include <fmt/format.h>

#include <array>
#include <numbers>
#include <stdexcept>

#include "dem/packing/packing.hpp"
#include "dem/prepare/prepare.hpp"

namespace sandgraph::scene {
namespace {

constexpr double degree = std::numbers::pi / 180;

// Porosity that the paper's two densities stand for; the preparation finds the friction that gives it.
struct Preset {
    const char* density;
    double porosity;
};
constexpr Preset presets[] = {{"dense", 0.16}, {"loose", 0.20}};

// A name the table knows, kept as text in the struct.
class DensityName : public Choice {
  public:
    explicit DensityName(std::string& density)
        : Choice(
              names(), [&density](std::size_t i) { density = names()[i]; },
              [&density] { return density == "dense"   ? 0u
                                  : density == "loose" ? 1u
                                                       : 2u; }) {}

  private:
    static std::vector<std::string> names() { return {"dense", "loose", "custom"}; }
};

}  // namespace

void add_material_keys(KeyTable& keys, dem::Material& m) {
    auto grains = keys.section("grains");
    grains.real("grain_density", m.density, "kg/m3", above(0), "density of the grains");
    grains.real("young", m.young, "MPa", above(0), "contact modulus E; k_n = E r*");
    grains.real("stiffness_ratio", m.stiffness_ratio, "", above(0), "k_t / k_n");
    grains.real("friction_angle", m.friction_angle, "deg", within(0, 80 * degree), "between grains");
    grains.real("rolling_stiffness", m.rolling_stiffness, "", at_least(0), "beta; k_r = beta k_t r_i r_j");
    grains.real("rolling_limit", m.rolling_limit, "", at_least(0), "eta; |M| <= eta min(r_i, r_j) f_n");
    grains.real("damping", m.damping, "", within(0, 0.9), "local damping alpha");
    grains.real("depth", m.depth, "m", above(0),
                "thickness of the disks and the cell; 20 mean radii unless given");
    grains.choice("rolling_form", m.rolling_form, {"incremental", "total"},
                  "elastic-plastic, or eq. 10 as read");
}

void add_disk_keys(KeyTable& keys, Grains& g) {
    auto grains = keys.section("grains");
    grains.integer("count", g.count, 20, "disks in a packing");
    grains.real("radius_min", g.radius_min, "mm", above(0), "smallest disk");
    grains.real("radius_max", g.radius_max, "mm", above(0), "largest disk");
    grains.real("consolidation_pressure", g.consolidation_pressure, "kPa", above(0), "of the base packing");
}

void add_grain_keys(KeyTable& keys, Grains& g) {
    auto grains = keys.section("grains");
    grains.add("density", std::make_unique<DensityName>(g.density),
               "dense: porosity 0.16; loose: 0.20; custom: by target_porosity");
    grains.real("target_porosity", g.target_porosity, "", within(0.1, 0.3),
                "2D, of the base packing (custom)");
    add_disk_keys(keys, g);
    grains.integer("seed", g.seed, 0, "of the random packing; another seed is another sample");
    grains.input_file("packing", g.packing, "start from this .csv or .h5 instead of the recipe").in_hash =
        false;
    add_material_keys(keys, g.material);
}

void add_stepping_keys(KeyTable& keys, graph::RveSettings& r) {
    auto rve = keys.section("rve");
    rve.real("time_step_fraction", r.time_step_fraction, "", above_up_to(0, 1),
             "DEM time step as a share of the longest stable one");
    rve.real("inertial_number_max", r.inertial_number_max, "", above(0),
             "bound on I; smaller is slower, truer");
    rve.real("strain_per_step_max", r.strain_per_step_max, "", above_up_to(0, 1e-2),
             "bound on a DEM step's strain");
    rve.real("pressure_floor", r.pressure_floor, "Pa", above(0),
             "p below which the bound on I stops tightening");
    rve.real("update_tolerance", r.update_tolerance, "", at_least(0),
             "error aimed at of the stress predicted between updates, share of p; 0: no prediction");
    rve.real("update_change_max", r.update_change_max, "", at_least(0),
             "largest predicted stress change between updates, share of p");
    rve.choice("predictor", r.predictor, {"elastic", "secant"},
               "stress between updates: by small-strain stiffness, or less what last answers fell short");
    rve.integer("steps_min", r.steps_min, 1, "DEM steps of an update at least");
    rve.real("stress_per_step_max", r.stress_per_step_max, "", above(0),
             "bound on a DEM step's elastic stress change, share of p, in updates of up to 10 steps");
    rve.real("rate_jump_max", r.rate_jump_max, "", at_least(0),
             "an update that goes on as the last one settles only if its rate is more times that; 0: always");
    rve.real("steady_factor", r.steady_factor, "", at_least(1),
             "by which the bounds on I and on a step's strain loosen at most since the last reversal");
    rve.real("steady_strain", r.steady_strain, "", above(0),
             "strain since the last reversal from which they do");
    rve.integer("steps_max", r.steps_max, 0,
                "DEM steps of an update at most, the rest in the next MPM steps; 0: no bound");
    rve.choice("kernel", r.kernel, {"double", "mixed"},
               "precision of the DEM step: double, or float forces on exact positions (faster)");
}

void complete_grains(const KeyTable& keys, Grains& g) {
    for (const Preset& preset : presets)
        if (g.density == preset.density) g.target_porosity = preset.porosity;
    if (const Key& porosity = keys.at("grains.target_porosity"); g.density == "custom" && !porosity.given)
        throw InputError(keys.at("grains.density").where, "grains.density = \"custom\"",
                         "it has no porosity of its own", "write grains.target_porosity, too");
    check_disks(keys, g);
    if (!keys.at("grains.depth").given) g.material.depth = dem::usual_depth(g.radius_min, g.radius_max);
}

void check_pressure(const Key& key, double pressure, const Grains& g) {
    const std::array radii{g.radius_min, g.radius_max};
    const double most = dem::bearable_pressure(dem::grain_scale(radii, g.material));
    if (!g.packing.empty() || pressure <= most) return;
    throw InputError(
        key.where, fmt::format("{} = {}", key.full_name(), key.value->shown()),
        fmt::format("a mean stress of {:.5g} kPa presses the grains into each other, which bear {:.5g} kPa",
                    pressure / 1e3, most / 1e3),
        fmt::format("write {:.5g} kPa less at least, or stiffer grains (grains.young)",
                    (pressure - most) / 1e3));
}

double porosity_of(const std::string& density) {
    for (const Preset& preset : presets)
        if (density == preset.density) return preset.porosity;
    throw std::logic_error("no porosity of density " + density);
}

std::string density_name(double porosity) {
    for (const Preset& preset : presets)
        if (porosity == preset.porosity) return preset.density;
    return "custom";
}

void check_disks(const KeyTable& keys, const Grains& g) {
    constexpr int most = 65000;  // the kernel's pairs count grains in 16 bits
    if (g.count > most)
        throw InputError(keys.at("grains.count").where, fmt::format("grains.count = {}", g.count),
                         fmt::format("a packing holds {} grains at most", most),
                         "some hundred make a representative volume");
    if (g.radius_min > g.radius_max) {
        const Key& key = keys.at("grains.radius_min");
        throw InputError(key.where, fmt::format("grains.radius_min = {}", key.value->shown()),
                         fmt::format("above radius_max = {}", keys.at("grains.radius_max").value->shown()),
                         "write radius_min <= radius_max");
    }
    if (g.radius_max > dem::widest_grading * g.radius_min)
        throw InputError(keys.at("grains.radius_min").where,
                         fmt::format("grains.radius_min = {}", keys.at("grains.radius_min").value->shown()),
                         fmt::format("radius_max is more than {:g} times larger", dem::widest_grading),
                         "write radii closer to each other");
    if (const Key& damping = keys.at("grains.damping"); g.packing.empty() && g.material.damping == 0)
        throw InputError(damping.where, "grains.damping = 0",
                         "without damping the grains ring on and no packing comes to rest",
                         fmt::format("write {:g}", dem::Material{}.damping));
    check_pressure(keys.at("grains.consolidation_pressure"), g.consolidation_pressure, g);
}

}  // namespace sandgraph::scene

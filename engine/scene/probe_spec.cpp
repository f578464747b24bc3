#include "scene/probe_spec.hpp"

#include <fmt/format.h>

#include "scene/effects.hpp"
#include "scene/file_kind.hpp"
#include "scene/grain_keys.hpp"
#include "scene/toml_file.hpp"

namespace sandgraph::scene {
namespace {

void add_packing_keys(KeyTable& keys, ProbePackings& p) {
    auto packings = keys.section("packings");
    packings.integer("seeds", p.seeds, 1, "base packings of each porosity");
    packings.integer("first_seed", p.first_seed, 0, "of the random packings, then rising");
    packings.add("porosities", std::make_unique<RisingReals>(p.porosities, within(0.1, 0.3)),
                 "2D, of the base packings (dense 0.16, loose 0.20)");
    packings.integer("pressures", p.pressures, 1, "of each base packing, spread log-uniformly");
    packings.real("pressure_min", p.pressure_min, "kPa", above(0), "isotropic stress at the start");
    packings.real("pressure_max", p.pressure_max, "kPa", above(0), "isotropic stress at the start");
}

void add_path_keys(KeyTable& keys, ProbePaths& p) {
    auto paths = keys.section("paths");
    paths.integer("proportional", p.proportional, 0, "straight paths in every direction of strain");
    paths.integer("constant_volume", p.constant_volume, 0, "straight isochoric shear");
    paths.integer("constant_pressure", p.constant_pressure, 0,
                  "straight shear, the volume led so that p stays near a slowly moving target");
    paths.integer("cyclic", p.cyclic, 0, "shear that reverses");
    paths.integer("dither", p.dither, 0, "small random increments about a slow trend");
    paths.integer("rotating", p.rotating, 0, "principal axes that turn, with spin");
    paths.integer("mixed", p.mixed, 0, "several legs: load, unload, turn, p rising or falling");
    paths.integer("flow", p.flow, 0,
                  "long shear at slowly moving p, pulled apart and pressed together between");
    paths.real("length_min", p.length_min, "", above(0), "of a path, sum of |strain increment|");
    paths.real("length_max", p.length_max, "", above_up_to(0, 10), "of a path");
    paths.real("increment_min", p.increment_min, "", above(0),
               "|strain increment| of an update; smaller at low p");
    paths.real("increment_max", p.increment_max, "", above_up_to(0, 0.01), "of an update");
    paths.integer("rows_max", p.rows_max, 10, "updates of a history at most");
    paths.integer("dither_rows", p.dither_rows, 10, "updates of a dithering history");
    paths.integer("flow_rows", p.flow_rows, 10, "updates of a flowing history");
    paths.real("flow_length", p.flow_length, "", above_up_to(0, 10), "of a leg of flow at most");
    paths.real("pressure_stop", p.pressure_stop, "kPa", above(0), "p at which a history ends");
    paths.integer("twin_every", p.twin_every, 0,
                  "every how many-th history has twins, for the noise floor; 0: none");
}

void in_order(const KeyTable& keys, const char* low, const char* high, bool good) {
    if (good) return;
    const Key& key = keys.at(keys.at(low).given ? low : high);
    throw InputError(key.where, fmt::format("{} = {}", key.full_name(), key.value->shown()),
                     fmt::format("{} = {} is not below {} = {}", low, keys.at(low).value->shown(), high,
                                 keys.at(high).value->shown()),
                     "change one of them");
}

}  // namespace

KeyTable probe_keys(ProbeSpec& probe) {
    KeyTable keys;
    keys.section("").integer("seed", probe.seed, 0, "of the strain paths");
    add_packing_keys(keys, probe.packings);
    add_path_keys(keys, probe.paths);
    add_disk_keys(keys, probe.grains);
    add_material_keys(keys, probe.grains.material);
    add_stepping_keys(keys, probe.rve);
    return keys;
}

ProbeSpec read_probe(const std::string& file) {
    ProbeSpec probe;
    probe.file = file;
    probe.text = read_text(file);
    KeyTable keys = probe_keys(probe);
    const toml::table table = parse_toml(probe.text, file);
    require_kind(table, file, FileKind::probe);
    keys.read(table, file);
    check_effects(keys, FileKind::probe);
    check_disks(keys, probe.grains);
    const ProbePaths& p = probe.paths;
    in_order(keys, "packings.pressure_min", "packings.pressure_max",
             probe.packings.pressure_min <= probe.packings.pressure_max);
    in_order(keys, "paths.length_min", "paths.length_max", p.length_min <= p.length_max);
    in_order(keys, "paths.increment_min", "paths.increment_max", p.increment_min <= p.increment_max);
    in_order(keys, "packings.pressure_max", "paths.pressure_stop",
             probe.packings.pressure_max < p.pressure_stop);
    check_pressure(keys.at("packings.pressure_max"), probe.packings.pressure_max, probe.grains);
    return probe;
}

}  // namespace sandgraph::scene

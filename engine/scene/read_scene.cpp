#include "scene/read_scene.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "scene/alignment.hpp"
#include "scene/check_scene.hpp"
#include "scene/effects.hpp"
#include "scene/expected_ground.hpp"
#include "scene/file_kind.hpp"
#include "scene/grain_keys.hpp"
#include "scene/scene_keys.hpp"
#include "scene/toml_file.hpp"

namespace sandgraph::scene {
namespace {

std::string to_text(const toml::table& table) {
    std::ostringstream out;
    out << toml::toml_formatter{table, toml::toml_formatter::default_flags} << '\n';
    return out.str();
}

// A vertical plate stands in the middle unless the scene says where.
void place_anchor(const KeyTable& keys, Scene& scene) {
    const bool free = scene.anchor.orientation == Orientation::vertical && !keys.at("anchor.position").given;
    if (!free) return;
    // As near to the middle as the points let the plate stand (check_scene).
    const double spacing = point_spacing(scene.domain), half = 0.5 * scene.anchor.thickness;
    scene.anchor.position = std::round((0.5 * scene.domain.width - half) / spacing) * spacing + half;
}

// Bodies stand instead of the anchor where the scene has no [anchor]. The one that is loaded gives the width
// that loads and marks count in.
void place_bodies(const KeyTable& keys, Scene& scene) {
    const bool anchored =
        std::ranges::any_of(keys.keys(), [](const Key& key) { return key.section == "anchor" && key.given; });
    if (!scene.bodies.empty() && !anchored) scene.anchor.present = false;
    const Body* body = scene.loaded_body();
    if (!body) return;
    Anchor& a = scene.anchor;
    a.width = body->width(), a.pull_to = body->travel / a.width;
    a.pull_rate = std::hypot(body->velocity[0], body->velocity[1]);
    a.ramp = body->ramp * a.pull_to;
    a.friction_angle = body->friction_angle;
}

// A key that lost its effect by an override would be refused in the text that a run keeps.
void drop_idle(toml::table& table, const KeyTable& keys) {
    for (const Key& key : keys.keys())
        if (key.given && is_idle(keys, key, FileKind::scene)) table[key.section].as_table()->erase(key.name);
}

Scene parse(const std::string& text, const std::string& file, std::span<const std::string> overrides,
            NamedFiles files) {
    Scene scene;
    scene.file = file;
    toml::table table = parse_toml(text, file);
    require_kind(table, file, FileKind::scene);
    KeyTable keys = scene_keys(scene);
    keys.read(table, file, files);
    for (const std::string& assignment : overrides) {
        const toml::table extra = parse_override(assignment);
        keys.read(extra, override_file);
        merge(table, extra);
    }
    place_bodies(keys, scene);
    if (files == NamedFiles::exist) check_effects(keys, FileKind::scene);  // what is over, is
    if (!overrides.empty()) drop_idle(table, keys);
    scene.text = overrides.empty() ? text : to_text(table);
    scene.given = keys.given();
    complete_grains(keys, scene.ground.grains);
    place_anchor(keys, scene);
    if (scene.anchor.present && !keys.at("anchor.pull_rate").given)
        scene.anchor.pull_rate = default_pull_rate(scene);
    check_scene(scene, keys);
    return scene;
}

}  // namespace

Scene parse_scene(const std::string& text, const std::string& file, std::span<const std::string> overrides) {
    return parse(text, file, overrides, NamedFiles::exist);
}

Scene recorded_scene(const std::string& text, const std::string& name) {
    return parse(text, name, {}, NamedFiles::may_be_gone);
}

Scene read_scene(const std::string& file, std::span<const std::string> overrides) {
    return parse_scene(read_text(file), file, overrides);
}

}  // namespace sandgraph::scene

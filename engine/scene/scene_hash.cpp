#include "scene/scene_hash.hpp"

#include <fmt/format.h>

#include "base/hash.hpp"
#include "scene/scene_keys.hpp"
#include "scene/toml_file.hpp"

namespace sandgraph::scene {

std::string canonical_text(const Scene& scene) {
    Scene copy = scene;
    const KeyTable table = scene_keys(copy);
    std::string text;
    for (const Key& key : table.keys())
        if (key.in_hash) text += fmt::format("{}={}\n", key.full_name(), key.value->canonical());
    const std::string& packing = scene.ground.grains.packing;
    if (!packing.empty()) text += fmt::format("packing={}\n", hex(hash64(read_text(packing))));
    const std::string& model = scene.screening.model;
    if (scene.mode == Mode::screening && !model.empty())
        text += fmt::format("surrogate={}\n", hex(hash64(read_text(model))));
    return text;
}

std::uint64_t scene_hash(const Scene& scene) { return hash64(canonical_text(scene)); }

}  // namespace sandgraph::scene

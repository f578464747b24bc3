#include "packings/packing_material.hpp"

#include <fmt/format.h>

#include "packings/base_packing.hpp"
#include "scene/grain_keys.hpp"

namespace sandgraph::packings {
namespace {

struct Difference {
    std::string name, used, of_packing;  // "grains.young" and its values as a file has them
};

scene::KeyTable keys_of(dem::Material& material) {
    scene::KeyTable keys;
    scene::add_material_keys(keys, material);
    return keys;
}

std::vector<Difference> differences(dem::Material used, dem::Material of_packing) {
    const scene::KeyTable ours = keys_of(used), theirs = keys_of(of_packing);
    std::vector<Difference> out;
    for (std::size_t k = 0; k < ours.keys().size(); ++k) {
        const scene::Value &a = *ours.keys()[k].value, &b = *theirs.keys()[k].value;
        if (a.canonical() != b.canonical()) out.push_back({ours.keys()[k].full_name(), a.shown(), b.shown()});
    }
    return out;
}

void refuse_contradiction(const scene::Grains& grains, const dem::Material& of_packing,
                          const scene::GivenKeys& given) {
    for (const Difference& d : differences(grains.material, of_packing))
        if (const auto at = given.find(d.name); at != given.end())
            throw InputError(at->second, fmt::format("{} = {}", d.name, d.used),
                             fmt::format("the packing brings its own material: {} was prepared with {}",
                                         grains.packing, d.of_packing),
                             "leave it out, or prepare a packing with it");
}

}  // namespace

void take_packing_material(scene::Grains& grains, const scene::GivenKeys& given) {
    if (grains.packing.empty()) return;
    const io::PackingRecord record = load_packing(grains.packing);
    if (has_material(grains.packing)) {
        refuse_contradiction(grains, record.material, given);
        grains.material = record.material;
    }
    grains.count = static_cast<int>(record.packing.size());
    grains.density = "custom";
    grains.target_porosity = dem::porosity(record.packing);
}

std::string changed_material(const dem::Material& used, const dem::Material& of_packing) {
    std::string out;
    for (const Difference& d : differences(used, of_packing))
        out += fmt::format("{}{} = {} instead of the packing's {}", out.empty() ? "" : ", ", d.name, d.used,
                           d.of_packing);
    return out;
}

}  // namespace sandgraph::packings

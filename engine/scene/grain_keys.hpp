#pragma once
#include "scene/key_table.hpp"
#include "scene/scene.hpp"

namespace sandgraph::scene {

// Contact parameters of the grains, keys of [grains] in scenes, recipes and element tests.
void add_material_keys(KeyTable& keys, dem::Material& material);

// Number and sizes of the disks, [grains], and their check as a whole.
void add_disk_keys(KeyTable& keys, Grains& grains);
void check_disks(const KeyTable& keys, const Grains& grains);

// Refuses a pressure [Pa] that the grains of this recipe do not bear; `key` says what to lower.
void check_pressure(const Key& key, double pressure, const Grains& grains);

// "dense", "loose" or "custom" by target porosity; the porosity of "dense" or "loose".
std::string density_name(double porosity);
double porosity_of(const std::string& density);

// The whole recipe, [grains].
void add_grain_keys(KeyTable& keys, Grains& grains);

// How packings follow strain, [rve].
void add_stepping_keys(KeyTable& keys, graph::RveSettings& rve);

// After reading: fills in what density = "dense" or "loose" stands for, and checks the grains as a whole.
void complete_grains(const KeyTable& keys, Grains& grains);

}  // namespace sandgraph::scene

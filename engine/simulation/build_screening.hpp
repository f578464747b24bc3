#pragma once
#include <filesystem>
#include <memory>

#include "graph/screening/law.hpp"
#include "io/screening_record.hpp"
#include "packings/in_situ.hpp"
#include "scene/scene.hpp"

namespace sandgraph::simulation {

// The weights file of a screening scene: its own, else the shipped one in the folder of the scene, in a
// `configs/models` or `configs` folder above it, or in that of the program. InputError when there is none.
std::filesystem::path model_file(const scene::Scene& scene);

// `grains`: how the packings are driven where the surrogate is not trusted.
std::unique_ptr<stress::Law> screening_law(const scene::Scene& scene, const packings::PreparedGround& ground,
                                           graph::RveLawSetup grains);

// Switches and audits so far; empty for other laws.
io::ScreeningRecord screening_record(const stress::Law& law);

}  // namespace sandgraph::simulation

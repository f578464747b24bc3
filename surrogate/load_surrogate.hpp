#pragma once
#include <filesystem>
#include <memory>

#include "stress/surrogate.hpp"
#include "surrogate/model.hpp"

namespace sandgraph::surrogate {

// The law that serves a model.
std::unique_ptr<stress::Surrogate> make_surrogate(const Model& model);

// Loads a model file for serving. InputError on everything read_model, check_self_test and check_physics
// refuse.
std::unique_ptr<stress::Surrogate> load_surrogate(const std::filesystem::path& path);

}  // namespace sandgraph::surrogate

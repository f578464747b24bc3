#pragma once
#include <filesystem>
#include <string>

#include "dem/packing/packing.hpp"

// Valid files of every kind, small, for fuzzing to start from.
namespace sandgraph::fuzz {

dem::Packing two_grains();

void write_text(const std::filesystem::path& file, const std::string& text);
void write_csv(const std::filesystem::path& file);
void write_packing(const std::filesystem::path& file);
void write_scene(const std::filesystem::path& file);
void write_element_test(const std::filesystem::path& file);
void write_recipe(const std::filesystem::path& file);
void write_segments(const std::filesystem::path& file);
void write_probe(const std::filesystem::path& file);
void write_train(const std::filesystem::path& file);
void write_sweep(const std::filesystem::path& file);
void write_checkpoint(const std::filesystem::path& file);
void write_state(const std::filesystem::path& file);  // a checkpoint of a whole ground
void write_history(const std::filesystem::path& file);
void write_run(const std::filesystem::path& file);
void write_model(const std::filesystem::path& file);

}  // namespace sandgraph::fuzz

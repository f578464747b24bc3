#include "fuzz/readers.hpp"

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "dem/packing/csv.hpp"
#include "fuzz/samples.hpp"
#include "fuzz/small_state.hpp"
#include "io/checkpoint.hpp"
#include "io/content.hpp"
#include "io/history_file.hpp"
#include "io/info.hpp"
#include "io/packing_file.hpp"
#include "io/run_record.hpp"
#include "scene/element_test_spec.hpp"
#include "scene/probe_spec.hpp"
#include "scene/read_scene.hpp"
#include "scene/recipe_spec.hpp"
#include "scene/segments.hpp"
#include "scene/sweep_rows.hpp"
#include "scene/train_spec.hpp"
#include "surrogate/load_surrogate.hpp"

namespace sandgraph::fuzz {
namespace fs = std::filesystem;
namespace {

void read_segments(const fs::path& file) {
    const fs::path test = file.string() + ".toml";
    write_text(test, "kind = \"path\"\nsegments = '''" + file.string() + "'''\n");
    scene::read_element_test(test.string());
}

void read_fields(const fs::path& file) {
    io::CheckpointReader in(file, "hash");
    std::vector<double> numbers;
    std::vector<std::uint8_t> bytes;
    in.field("numbers", numbers);
    in.field("bytes", bytes);
}

// The seal is made to fit, so that damage gets past it to what HDF5 and our reader make of it.
void reseal(const fs::path& file) {
    if (fs::file_size(file) > io::seal_size) io::seal(file);
}
void read_resealed(const fs::path& file) {
    reseal(file);
    read_fields(file);
}
// A checkpoint's state in whole, past the seal, as a run that is resumed reads it.
void read_state(const fs::path& file) {
    reseal(file);
    io::CheckpointReader in(file, "hash");
    try {
        small_state()->archive(in);
    } catch (const StateError& error) {
        throw InputError({file.string()}, error.what(), "not a state", "start anew");
    }
}
void read_model(const fs::path& file) {
    reseal(file);
    surrogate::load_surrogate(file);
}

void read_run(const fs::path& file) {
    const io::RunRecord run = io::read_run(file);
    for (std::size_t k = 0; k < run.frames; ++k) io::read_run_frame(file, k);
}

constexpr std::array<Reader, 16> table = {{
    {"scene", ".toml", [](const fs::path& f) { scene::read_scene(f.string()); }, write_scene},
    {"element_test", ".toml", [](const fs::path& f) { scene::read_element_test(f.string()); },
     write_element_test},
    {"recipe", ".toml", [](const fs::path& f) { scene::read_recipe(f.string()); }, write_recipe},
    {"probe", ".toml", [](const fs::path& f) { scene::read_probe(f.string()); }, write_probe},
    {"train", ".toml", [](const fs::path& f) { scene::read_train(f.string()); }, write_train},
    {"sweep", ".toml", [](const fs::path& f) { scene::read_sweep_table(f.string()); }, write_sweep},
    {"segments", ".csv", read_segments, write_segments},
    {"packing_csv", ".csv", [](const fs::path& f) { dem::read_packing_csv(f); }, write_csv},
    {"packing_h5", ".h5", [](const fs::path& f) { io::read_packing(f); }, write_packing},
    {"info", ".h5", [](const fs::path& f) { io::info(f); }, write_run},
    {"checkpoint", ".h5", read_fields, write_checkpoint},
    {"resealed", ".h5", read_resealed, write_checkpoint},
    {"state", ".h5", read_state, write_state},
    {"history_h5", ".h5", [](const fs::path& f) { io::read_history(f); }, write_history},
    {"model_h5", ".h5", read_model, write_model},
    {"run_h5", ".h5", read_run, write_run},
}};

}  // namespace

std::span<const Reader> readers() { return table; }

void read_hostile(const Reader& reader, const fs::path& file) {
    try {
        reader.read(file);
    } catch (const InputError& error) {
        if (std::string(error.what()).find('\n') != std::string::npos)
            throw std::logic_error(std::string("not one line: ") + error.what());
    }
}

}  // namespace sandgraph::fuzz

#include "fuzz/readers.hpp"

#include <array>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "dem/packing_csv.hpp"
#include "io/checkpoint.hpp"
#include "io/info.hpp"
#include "io/packing_file.hpp"
#include "io/seal.hpp"
#include "scene/element_test_spec.hpp"
#include "scene/read_scene.hpp"
#include "scene/recipe_spec.hpp"
#include "scene/segments.hpp"

namespace sandgraph::fuzz {
namespace fs = std::filesystem;
namespace {

void write_text(const fs::path& file, const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
}

dem::Packing two_grains() {
    dem::Packing packing;
    packing.H << 0.02, 0, 0, 0.01;
    packing.x = {0.005, 0.0148}, packing.y = {0.005, 0.005}, packing.r = {0.005, 0.005};
    packing.vx = packing.vy = packing.spin = {0, 0};
    packing.contacts = {{.i = 0, .j = 1, .tangential = 0.1, .moment = 1e-5}};
    return packing;
}

void write_csv(const fs::path& file) { dem::write_packing_csv(file, two_grains()); }
void write_h5(const fs::path& file) {
    io::write_packing(file, {.packing = two_grains(), .material = {}, .recipe = "seed = 1"});
}

void write_scene(const fs::path& file) {
    write_text(
        file,
        "title = \"x\"\n[anchor]\norientation = \"vertical\"\nembedment_ratio = 3\npull_rate = \"0.05 m/s\"\n"
        "[domain]\nwidth = \"10 m\"\ndepth = \"8 m\"\n[grains]\ndensity = \"loose\"\n[output]\nframes = [0, "
        "0.1]\n");
}
void write_element_test(const fs::path& file) {
    write_text(file,
               "kind = \"path\"\nmode = \"fast\"\ntime_step = \"1e-5 s\"\n[[segment]]\n"
               "velocity_gradient = [[0.1, 0.0], [0.0, -0.1]]\nsteps = 500\n");
}
void write_recipe(const fs::path& file) {
    write_text(file, "pressure = \"30 kPa\"\n[grains]\ncount = 400\ndensity = \"dense\"\nseed = 3\n");
}
void write_segments(const fs::path& file) {
    write_text(file, "Lxx,Lxy,Lyx,Lyy,steps\n0.1,0,0,-0.1,100\n0,1e-3,0,0,5\n");
}

void read_segments(const fs::path& file) {
    const fs::path test = file.string() + ".toml";
    write_text(test, "kind = \"path\"\nsegments = '''" + file.string() + "'''\n");
    scene::read_element_test(test.string());
}

void write_checkpoint(const fs::path& file) {
    fs::remove(file);
    io::CheckpointWriter out(file, {"hash", "git", 0.1});
    std::vector<double> numbers = {1, 2, 3};
    std::vector<std::uint8_t> bytes(100, 7);
    out.field("numbers", numbers);
    out.field("bytes", bytes);
    out.commit();
}

void read_fields(const fs::path& file) {
    io::CheckpointReader in(file, "hash");
    std::vector<double> numbers;
    std::vector<std::uint8_t> bytes;
    in.field("numbers", numbers);
    in.field("bytes", bytes);
}

// The seal is made to fit, so that damage gets past it to what HDF5 and our reader make of it.
void read_resealed(const fs::path& file) {
    if (fs::file_size(file) > io::seal_size) io::seal(file);
    read_fields(file);
}

constexpr std::array<Reader, 9> table = {{
    {"scene", ".toml", [](const fs::path& f) { scene::read_scene(f.string()); }, write_scene},
    {"element_test", ".toml", [](const fs::path& f) { scene::read_element_test(f.string()); },
     write_element_test},
    {"recipe", ".toml", [](const fs::path& f) { scene::read_recipe(f.string()); }, write_recipe},
    {"segments", ".csv", read_segments, write_segments},
    {"packing_csv", ".csv", [](const fs::path& f) { dem::read_packing_csv(f); }, write_csv},
    {"packing_h5", ".h5", [](const fs::path& f) { io::read_packing(f); }, write_h5},
    {"info", ".h5", [](const fs::path& f) { io::info(f); }, write_h5},
    {"checkpoint", ".h5", read_fields, write_checkpoint},
    {"resealed", ".h5", read_resealed, write_checkpoint},
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

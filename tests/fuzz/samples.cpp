#include "fuzz/samples.hpp"

#include <fstream>

#include "dem/packing/csv.hpp"
#include "fuzz/small_state.hpp"
#include "io/checkpoint.hpp"
#include "io/history_file.hpp"
#include "io/packing_file.hpp"
#include "io/run_file.hpp"
#include "support/paths.hpp"
#include "surrogate/model_file.hpp"
#include "tests/support/random_model.hpp"

namespace sandgraph::fuzz {
namespace fs = std::filesystem;
namespace {

io::HistoryPacking history_packing() {
    io::HistoryPacking packing;
    packing.hash = -17, packing.seed = 3, packing.target_porosity = 0.2;
    packing.traits = {10e3, 0.2, 20e6, 14e6, 3.4, 0.01, -0.02, 0.42};
    packing.stress << 10e3, 1, 2, 10e3;
    return packing;
}

io::Frame frame() {
    return {0.5, 0.01, 0, 1, {0.05, 0.15}, {0.05, 0.05}, {{"displacement", "m", 2, {0, 0.01, 0, 0.02}}}};
}

}  // namespace

dem::Packing two_grains() {
    dem::Packing packing;
    packing.H << 0.02, 0, 0, 0.01;
    packing.x = {0.005, 0.0148}, packing.y = {0.005, 0.005}, packing.r = {0.005, 0.005};
    packing.vx = packing.vy = packing.spin = {0, 0};
    packing.contacts = {{.i = 0, .j = 1, .tangential = 0.1, .moment = 1e-5}};
    return packing;
}

void write_text(const fs::path& file, const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
}

void write_csv(const fs::path& file) { dem::write_packing_csv(file, two_grains()); }
void write_packing(const fs::path& file) {
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

void write_probe(const fs::path& file) {
    fs::copy_file(fs::path(sandgraph::test::source_file("/configs/models/probe.toml")), file,
                  fs::copy_options::overwrite_existing);
}
void write_train(const fs::path& file) {
    write_text(
        file,
        "[data]\nlogs = [\"/proc/self/exe\"]\nheld_out_seeds = 1\n[model]\nrung = \"learned\"\nmembers = 4\n"
        "[training]\nepochs = 150\nrate = 2e-2\n");
}

void write_sweep(const fs::path& file) {
    write_text(file,
               "scene = \"/proc/self/exe\"\nsamples = 2\ncombine = \"zip\"\n[set]\ngrains.count = 100\n"
               "[[axis]]\nkey = \"anchor.embedment_ratio\"\nvalues = [2, 3]\n"
               "with = { \"domain.depth\" = [\"7 m\", \"8 m\"] }\n"
               "[[axis]]\nkey = \"grains.density\"\nvalues = [\"dense\", \"loose\"]\n");
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

void write_state(const fs::path& file) {
    fs::remove(file);
    io::CheckpointWriter out(file, {"hash", "git", 0.1});
    const auto state = small_state();
    shear(*state);
    state->archive(out);
    out.commit();
}

void write_history(const fs::path& file) {
    io::HistoryWriter out(file, {"probe", "seed = 1", "0.1", "abc"}, {{history_packing()}},
                          {{io::HistoryInfo{}}});
    io::HistoryRow first, second;
    second.sequence = 1, second.dem_steps = 7;
    out.append({{first, second}});
    out.commit();
}

// A run folder for a moment, of which run.h5 is kept.
void write_run(const fs::path& file) {
    const fs::path folder = file.string() + ".folder";
    io::RunFile run = io::RunFile::create(folder, {"title = \"x\"", "hash", "0.1", "git", "screening", 2});
    run.append(io::LoadRow{0.001, 10});
    run.set_timing("contact", 0.1);
    // More than eight: HDF5 keeps the names of a large group in another way.
    for (const char* name : {"a", "b", "c", "d", "e", "f", "g", "h", "updates"}) run.set_counter(name, 7);
    run.set_screening(
        {{"none", "strain"}, {{3, 0.001, 1, stress::Reason::strain, 0.1}}, {{0.01, 2, 100, 0.1, 0.05}}});
    run.append(frame());
    fs::copy_file(run.path(), file, fs::copy_options::overwrite_existing);
    fs::remove_all(folder);
}

void write_model(const fs::path& file) {
    surrogate::write_model(file,
                           support::random_model(1, {.members = 1, .elements = 2, .hidden = 2, .layers = 2}));
}

}  // namespace sandgraph::fuzz

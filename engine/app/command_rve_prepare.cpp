#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/command_rve.hpp"
#include "base/console.hpp"
#include "base/file_name.hpp"
#include "base/revision.hpp"
#include "dem/make_assembly.hpp"
#include "dem/packing/csv.hpp"
#include "dem/prepare/prepare.hpp"
#include "io/atomic_file.hpp"
#include "io/packing_file.hpp"
#include "packings/base_packing.hpp"
#include "packings/packing_material.hpp"
#include "scene/recipe_spec.hpp"

namespace sandgraph::app {
namespace {

struct Options {
    std::string recipe, out, csv;
};

dem::Packing make_packing(const scene::RecipeSpec& recipe) {
    StageProgress progress;
    const auto tell = [&progress](std::string_view stage, double fraction) {
        progress.update(stage, fraction);
    };
    const dem::Packing base = packings::base_packing(recipe.grains, tell);
    if (recipe.grains.packing.empty() && recipe.pressure == recipe.grains.consolidation_pressure) return base;
    const dem::Material& material = recipe.grains.material;
    return dem::compress_to(base, {.pressure = recipe.pressure}, material, dem::fast_assemblies(), tell);
}

void write_csv(const std::string& file, const dem::Packing& packing, const scene::RecipeSpec& recipe) {
    const nlohmann::json metadata{
        {"recipe", recipe.file}, {"pressure_Pa", recipe.pressure}, {"git", revision()}};
    io::AtomicFile csv(file);
    dem::write_packing_csv(csv.temporary(), packing, metadata.dump());
    csv.commit();
}

void run(const Options& options) {
    scene::RecipeSpec recipe = scene::read_recipe(options.recipe);
    packings::take_packing_material(recipe.grains, recipe.given);
    require_extension(options.out, ".h5", Naming::always),
        require_extension(options.csv, ".csv", Naming::always);
    io::require_writable_file(options.out), io::require_writable_file(options.csv);
    const dem::Packing packing = make_packing(recipe);
    if (!options.csv.empty()) write_csv(options.csv, packing, recipe);
    io::write_packing(options.out, {packing, recipe.grains.material, recipe.text});
    fmt::print("{}: {} grains at {:g} kPa, porosity {:.4f}\n", options.out, packing.size(),
               recipe.pressure / 1000, dem::porosity(packing));
}

}  // namespace

void add_rve_prepare(CLI::App& rve) {
    CLI::App* prepare = rve.add_subcommand("prepare", "makes a packing by a recipe");
    auto options = std::make_shared<Options>();
    prepare->add_option("recipe", options->recipe, "TOML file; `sandgraph keys recipe` lists its keys")
        ->required();
    prepare->add_option("-o,--out", options->out, "HDF5 file to write")->required();
    prepare->add_option("--csv", options->csv, "the packing as CSV, too (without contact history)");
    prepare->callback([options] { run(*options); });
}

}  // namespace sandgraph::app

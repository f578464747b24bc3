#include "scene/sweep_keys.hpp"

#include "scene/effects.hpp"
#include "scene/file_kind.hpp"
#include "scene/sweep_values.hpp"
#include "scene/toml_file.hpp"

namespace sandgraph::scene {
namespace {

void require_something_varied(const SweepSpec& spec) {
    if (!spec.axes.empty() || !spec.rows.empty() || spec.samples > 1) return;
    throw InputError({spec.file, 0}, "a sweep of nothing", "there are neither axes nor rows nor samples",
                     "write [[axis]] with key and values, or rows = \"FILE.csv\"");
}

}  // namespace

KeyTable sweep_keys(SweepSpec& spec) {
    KeyTable keys;
    auto top = keys.section("");
    top.text("title", spec.title, "of chart and page");
    top.input_file("scene", spec.scene, "base scene; what is not set or varied here is as it says");
    top.choice("mode", spec.mode, {"scene", "full", "screening"}, "of all runs, or as the scene says");
    top.integer("samples", spec.samples, 1,
                "runs a row, each of another base packing (drawn by grains.seed): mean and 95 % interval");
    top.choice("combine", spec.combine, {"product", "zip"},
               "every value of an axis with every one of the others, or the first with the first");
    top.input_file("rows", spec.rows,
                   "CSV instead of axes: its head names keys of the scene, each line is a row; a column "
                   "`name` names them");
    top.add("set", std::make_unique<SettingsTable>(spec.set), "keys of the scene, the same in all rows");
    top.add("axis", std::make_unique<AxisTables>(spec.axes), "what is varied");
    return keys;
}

SweepSpec read_sweep(const std::string& file) {
    SweepSpec spec;
    spec.file = file;
    KeyTable keys = sweep_keys(spec);
    const toml::table table = parse_toml(read_text(file), file);
    require_kind(table, file, FileKind::sweep);
    keys.read(table, file);
    check_effects(keys, FileKind::sweep);
    if (spec.scene.empty())
        throw InputError({file, 0}, "a sweep without a scene", "every run starts from one",
                         "write scene = \"FILE.toml\"");
    spec.given = keys.given();
    require_something_varied(spec);
    return spec;
}

}  // namespace sandgraph::scene

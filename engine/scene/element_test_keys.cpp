#include "scene/element_test_keys.hpp"

#include "scene/grain_keys.hpp"
#include "scene/segments.hpp"

namespace sandgraph::scene {
namespace {

void add_path_keys(KeyTable& keys, ElementTestSpec& spec) {
    auto top = keys.section("");
    top.integer("sample_every", spec.sample_every, 1, "steps (reference) or increments (fast) between rows");
    top.add("segment", std::make_unique<SegmentTables>(spec.segments),
            "[[segment]] tables: velocity_gradient = [[xx, xy], [yx, yy]] in 1/s, steps");
    top.add("segments", std::make_unique<SegmentFile>(spec.segments),
            "instead: CSV file Lxx,Lxy,Lyx,Lyy,steps");
}

void add_biaxial_keys(KeyTable& keys, ElementTestSpec& spec) {
    auto top = keys.section("");
    top.real("confining_pressure", spec.confining_pressure, "kPa", above(0),
             "lateral stress, held by a servo");
    top.real("axial_rate", spec.axial_rate, "1/s", above(0), "of the axial compression");
    top.real("axial_strain", spec.axial_strain, "", above_up_to(0, 3), "logarithmic, at the end");
    top.real("strain_every", spec.strain_every, "", above(0), "axial strain between rows");
}

void add_isotropic_keys(KeyTable& keys, ElementTestSpec& spec) {
    auto top = keys.section("");
    top.real("pressure", spec.confining_pressure, "kPa", above(0), "mean stress to reach");
    top.real("rate", spec.axial_rate, "1/s", above(0), "largest strain rate of the servo");
    top.integer("sample_every", spec.sample_every, 1, "steps between rows");
}

}  // namespace

KeyTable element_test_keys(ElementTestSpec& spec) {
    KeyTable keys;
    auto top = keys.section("");
    top.choice("kind", spec.kind, {"path", "biaxial", "isotropic"},
               "strain path, or stress-driven compression");
    top.choice("mode", spec.mode, {"reference", "fast"}, "the published step, or the optimised kernel");
    top.real("time_step", spec.time_step, "s", above(0), "of the DEM (reference), of an increment (fast)");
    top.integer("relax_steps", spec.relax_steps, 0, "steps at rest before the test");
    if (spec.kind == TestKind::path) add_path_keys(keys, spec);
    if (spec.kind == TestKind::biaxial) add_biaxial_keys(keys, spec);
    if (spec.kind == TestKind::isotropic) add_isotropic_keys(keys, spec);
    add_material_keys(keys, spec.material);
    add_stepping_keys(keys, spec.rve);
    return keys;
}

}  // namespace sandgraph::scene

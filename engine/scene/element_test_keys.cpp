#include "scene/element_test_keys.hpp"

#include "scene/grain_keys.hpp"
#include "scene/segments.hpp"

namespace sandgraph::scene {
namespace {

void add_keys(KeyTable& keys, dem::PathTest& test) {
    auto top = keys.section("");
    top.integer("sample_every", test.sample_every, 1, "steps (reference) or increments (fast) between rows");
    top.add("segment", std::make_unique<SegmentTables>(test.segments),
            "[[segment]] tables: velocity_gradient = [[xx, xy], [yx, yy]] in 1/s, steps");
    top.add("segments", std::make_unique<SegmentFile>(test.segments),
            "instead: CSV file Lxx,Lxy,Lyx,Lyy,steps");
}

void add_keys(KeyTable& keys, dem::BiaxialTest& test) {
    auto top = keys.section("");
    top.real("confining_pressure", test.confining_pressure, "kPa", above(0),
             "lateral stress, held by a servo");
    top.real("axial_rate", test.axial_rate, "1/s", above(0), "of the axial compression");
    top.real("axial_strain", test.axial_strain, "", above_up_to(0, 3), "logarithmic, at the end");
    top.real("strain_every", test.strain_every, "", above(0), "axial strain between rows");
}

void add_keys(KeyTable& keys, dem::IsotropicTest& test) {
    auto top = keys.section("");
    top.real("pressure", test.pressure, "kPa", above(0), "mean stress to reach");
    top.real("rate", test.rate, "1/s", above(0), "largest strain rate of the servo");
    top.integer("sample_every", test.sample_every, 1, "steps between rows");
}

void add_keys(KeyTable& keys, dem::ShearTest& test) {
    auto top = keys.section("");
    top.real("mean_stress", test.mean_stress, "kPa", above(0), "(sxx + syy)/2, held by a servo on the area");
    top.real("shear_rate", test.shear_rate, "1/s", above(0), "velocity gradient dv_x/dy");
    top.real("shear_strain", test.shear_strain, "", above_up_to(0, 100), "gamma at the end");
    top.real("strain_every", test.strain_every, "", above(0), "shear strain between rows");
}

}  // namespace

std::vector<std::string> test_kind_names() { return {"path", "biaxial", "isotropic", "simple_shear"}; }

KeyTable element_test_keys(ElementTestSpec& spec) {
    KeyTable keys;
    auto top = keys.section("");
    top.choice("kind", spec.kind, test_kind_names(),
               "strain path, stress-driven compression, or shear at constant mean stress");
    top.choice("mode", spec.mode, {"reference", "fast"}, "the published step, or the optimised kernel");
    visit_test(spec, [&](auto& test) {
        top.real("time_step", test.time_step, "s", above(0),
                 "of the DEM (reference), of an increment (fast)");
        top.integer("relax_steps", test.relax_steps, 0, "steps at rest before the test");
        add_keys(keys, test);
    });
    add_material_keys(keys, spec.material);
    add_stepping_keys(keys, spec.rve);
    return keys;
}

}  // namespace sandgraph::scene

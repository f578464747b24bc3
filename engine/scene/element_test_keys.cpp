#include "scene/element_test_keys.hpp"

#include "scene/grain_keys.hpp"
#include "scene/segments.hpp"

namespace sandgraph::scene {
namespace {

using dem::usual_pressure, dem::usual_rate;

// A key that follows from the grains unless it is given; `usual` is its value for those of Table 1.
void derived(KeyTable& keys, const char* name, double& value, const char* unit, double usual,
             const std::string& meaning) {
    keys.section("").add(name, std::make_unique<DerivedReal>(value, unit, above(0), usual),
                         (meaning + "; default for Table 1 grains, other grains' in proportion").c_str());
}

void add_keys(KeyTable& keys, dem::PathTest& test) {
    auto top = keys.section("");
    top.real("time_step", test.time_step, "s", above(0), "of the DEM (reference), of an increment (fast)");
    top.integer("sample_every", test.sample_every, 1, "steps (reference) or increments (fast) between rows");
    top.add("segment", std::make_unique<SegmentTables>(test.segments),
            "[[segment]] tables: velocity_gradient = [[xx, xy], [yx, yy]] in 1/s, steps");
    top.add("segments", std::make_unique<SegmentFile>(test.segments),
            "instead: CSV file Lxx,Lxy,Lyx,Lyy,steps");
}

void add_keys(KeyTable& keys, dem::BiaxialTest& test) {
    auto top = keys.section("");
    derived(keys, "time_step", test.time_step, "s", dem::usual_time_step, "of the DEM");
    derived(keys, "confining_pressure", test.confining_pressure, "kPa", usual_pressure,
            "lateral stress, held by a servo");
    derived(keys, "axial_rate", test.axial_rate, "1/s", usual_rate, "of the axial compression");
    top.real("axial_strain", test.axial_strain, "", above_up_to(0, 3), "logarithmic, at the end");
    top.real("strain_every", test.strain_every, "", above(0), "axial strain between rows");
}

void add_keys(KeyTable& keys, dem::IsotropicTest& test) {
    auto top = keys.section("");
    derived(keys, "time_step", test.time_step, "s", dem::usual_time_step, "of the DEM");
    derived(keys, "pressure", test.pressure, "kPa", usual_pressure, "mean stress to reach");
    derived(keys, "rate", test.rate, "1/s", usual_rate, "largest strain rate of the servo");
    top.integer("sample_every", test.sample_every, 1, "steps between rows");
}

void add_keys(KeyTable& keys, dem::ShearTest& test) {
    auto top = keys.section("");
    derived(keys, "time_step", test.time_step, "s", dem::usual_time_step, "of the DEM");
    derived(keys, "mean_stress", test.mean_stress, "kPa", usual_pressure,
            "(sxx + syy)/2, held by a servo on the area");
    derived(keys, "shear_rate", test.shear_rate, "1/s", usual_rate, "velocity gradient dv_x/dy");
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
    top.choice("mode", spec.mode, {"reference", "fast", "mixed"},
               "the published step, the optimised kernel, or that in mixed precision");
    visit_test(spec, [&](auto& test) {
        top.integer("relax_steps", test.relax_steps, 0, "steps at rest before the test");
        add_keys(keys, test);
    });
    add_material_keys(keys, spec.material);
    add_stepping_keys(keys, spec.rve);
    return keys;
}

}  // namespace sandgraph::scene

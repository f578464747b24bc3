#include <fmt/format.h>

#include "scene/effects.hpp"
#include "scene/element_test_keys.hpp"
#include "scene/element_test_spec.hpp"
#include "scene/file_kind.hpp"
#include "scene/toml_file.hpp"

namespace sandgraph::scene {
namespace {

// `kind` decides which other keys there are, so it is read first.
TestKind read_kind(const toml::table& table, const std::string& file) {
    TestKind kind = TestKind::path;
    KeyTable keys;
    keys.section("").choice("kind", kind, test_kind_names(), "");
    const toml::node* node = table.get("kind");
    if (!node)
        throw InputError({file, 0}, "no key kind", "it says which test to run", "write kind = \"path\"");
    const InputError::Where where{file, static_cast<int>(node->source().begin.line)};
    keys.at("kind").value->read({*node, where, "kind"});
    return kind;
}

void need_one_source(const KeyTable& keys, const std::string& file) {
    const Key &tables = keys.at("segment"), &csv = keys.at("segments");
    if (tables.given && csv.given)
        throw InputError(csv.where, "segments beside [[segment]]", "the path is given twice",
                         "remove one of them");
    if (!tables.given && !csv.given)
        throw InputError({file, 0}, "no segments", "a path needs one at least",
                         "write [[segment]] tables or segments = \"FILE.csv\"");
}

// A velocity gradient that strains or turns the sample by more than this in one step is no motion of grains.
constexpr double kLargestStep = 1e-2;

void check_rate(double rate, double time_step, const InputError::Where& where) {
    if (rate * time_step <= kLargestStep * (1 + 1e-9)) return;
    throw InputError(
        where, fmt::format("a rate of {:g} 1/s", rate),
        fmt::format("it strains the sample by {:g} in each time step of {:g} s", rate * time_step, time_step),
        fmt::format("write at most {:g} 1/s, or a shorter time_step", kLargestStep / time_step));
}

struct RateKey {
    const char* name;
    double rate;
};
RateKey rate_of(const dem::BiaxialTest& test) { return {"axial_rate", test.axial_rate}; }
RateKey rate_of(const dem::IsotropicTest& test) { return {"rate", test.rate}; }
RateKey rate_of(const dem::ShearTest& test) { return {"shear_rate", test.shear_rate}; }

template <class Test>
void check_rates(const KeyTable& keys, const Test& test, const std::string& file) {
    const auto [name, rate] = rate_of(test);
    const Key& key = keys.at(name);
    // Both derived, a rate and a step fit each other; one of them is judged beside the other's usual value.
    check_rate(rate > 0 ? rate : dem::usual_rate, test.time_step > 0 ? test.time_step : dem::usual_time_step,
               key.given ? key.where : InputError::Where{file, 0});
}

void check_rates(const KeyTable& keys, const dem::PathTest& test, const std::string&) {
    const Key& source = keys.at(keys.at("segments").given ? "segments" : "segment");
    for (const dem::PathSegment& s : test.segments)
        check_rate(s.velocity_gradient.norm(), test.time_step, source.where);
}

}  // namespace

ElementTestSpec read_element_test(const std::string& file, const dem::Material& material) {
    const toml::table table = parse_toml(read_text(file), file);
    require_kind(table, file, FileKind::element_test);
    ElementTestSpec spec;
    spec.material = material;
    spec.kind = read_kind(table, file);
    KeyTable keys = element_test_keys(spec);
    keys.read(table, file);
    check_effects(keys, FileKind::element_test);
    if (spec.kind == TestKind::path) need_one_source(keys, file);
    visit_test(spec, [&](const auto& test) { check_rates(keys, test, file); });
    return spec;
}

}  // namespace sandgraph::scene

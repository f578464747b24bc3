#pragma once
#include <string>

#include "dem/element_test/element_test.hpp"
#include "dem/make_assembly.hpp"
#include "graph/settings.hpp"

namespace sandgraph::scene {

enum class TestKind { path, biaxial, isotropic, simple_shear };

// A checked element test in SI, compression positive. Only the test of its kind has been read.
struct ElementTestSpec {
    TestKind kind = TestKind::path;
    dem::Kernel mode = dem::Kernel::fast;
    dem::Material material;
    graph::RveSettings rve;  // mode = fast or mixed
    dem::PathTest path;
    dem::BiaxialTest biaxial;
    dem::IsotropicTest isotropic;
    dem::ShearTest shear;
};

// Calls `visitor` with the test of the spec's kind.
template <class Spec, class Visitor>
decltype(auto) visit_test(Spec& spec, Visitor&& visitor) {
    switch (spec.kind) {
        case TestKind::path:
            return visitor(spec.path);
        case TestKind::biaxial:
            return visitor(spec.biaxial);
        case TestKind::isotropic:
            return visitor(spec.isotropic);
        case TestKind::simple_shear:
            break;
    }
    return visitor(spec.shear);
}

// Reads and checks an element test file; `material` stands where its [grains] say nothing. Throws InputError.
ElementTestSpec read_element_test(const std::string& file, const dem::Material& material = {});

}  // namespace sandgraph::scene

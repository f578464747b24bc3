#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "base/tensor.hpp"
#include "dem/material.hpp"
#include "scene/scene.hpp"

namespace sandgraph::scene {

// A constant velocity gradient L_ij = dv_i/dx_j [1/s] over `steps` time steps.
struct StrainSegment {
    Mat2 velocity_gradient = Mat2::Zero();
    std::int64_t steps = 0;
};

enum class TestKind { path, biaxial, isotropic, simple_shear };
enum class Kernel { reference, fast };

// A checked element test in SI, compression positive. Only the members of its kind have been read.
struct ElementTestSpec {
    TestKind kind = TestKind::path;
    Kernel mode = Kernel::reference;
    double time_step = 1e-5;  // [s]
    int relax_steps = 2000;   // at L = 0, before the test, not counted in it
    dem::Material material;
    graph::RveSettings rve;  // mode = fast

    int sample_every = 500;               // path: steps between rows
    std::vector<StrainSegment> segments;  // path

    double pressure = 64e3;  // biaxial: sigma_xx held; isotropic: p at the end; shear: p held [Pa]
    double rate = 0.1;    // biaxial: compression along y; shear: L_xy; isotropic: largest strain rate [1/s]
    double strain = 0.2;  // biaxial: -ln(hyy/hyy0) at the end; shear: gamma
    double strain_every = 0.0005;  // biaxial, shear: strain between rows
};

// Reads and checks an element test file; `material` stands where its [grains] say nothing. Throws InputError.
ElementTestSpec read_element_test(const std::string& file, const dem::Material& material = {});

}  // namespace sandgraph::scene

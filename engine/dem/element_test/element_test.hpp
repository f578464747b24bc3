#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "dem/assembly.hpp"

namespace sandgraph::dem {

// Element tests: one packing as a soil sample under uniform strain. Strains and stresses are compression
// positive.

// What is seen at one force evaluation. F [-] is the deformation gradient since the start of the test, H = F
// H_0 the sample's periods [m] (not re-reduced). Row `step` = m belongs to the m-th force evaluation, where
// F = (I + dt L)^(m-1) as in the YADE files: the last motion is not yet felt.
struct ElementRow {
    std::int64_t step = 0;
    double time = 0;  // [s]
    Mat2 F = Mat2::Identity(), H = Mat2::Identity();
    Observables seen;
};

// Strain-driven test: constant velocity gradients L_ij = dv_i/dx_j [1/s] in turn.
struct PathSegment {
    Mat2 L = Mat2::Zero();
    std::int64_t steps = 0;
};
struct PathTest {
    std::vector<PathSegment> segments;
    int relax_steps = 2000;  // at L = 0, before step 0
    int sample_every = 500;  // steps
    double dt = 1e-5;        // [s]
};
std::vector<ElementRow> run_path(Assembly& sample, const PathTest& test);

// Isotropic compression (or decompression) to `pressure` [Pa], both normal stresses servo-controlled.
struct IsotropicTest {
    double pressure = 0;      // [Pa]
    double rate = 0.1;        // largest normal strain rate [1/s]
    double tolerance = 1e-3;  // on both normal stresses, relative
    double modulus = 2e7;     // [Pa], see typical_modulus
    int relax_steps = 2000;
    int sample_every = 500;
    double dt = 1e-5;
    std::int64_t max_steps = 2'000'000;  // throws std::runtime_error when the pressure is not reached by then
};
std::vector<ElementRow> run_isotropic(Assembly& sample, const IsotropicTest& test);
// The same for the sake of the sample: no rows.
void compress(Assembly& sample, IsotropicTest test);

// Biaxial test: isotropic compression to the confining pressure, then axial shortening along y at a constant
// velocity gradient while a servo on the width holds sigma_xx.
struct BiaxialTest {
    double confining_pressure = 0;  // [Pa]
    double axial_rate = 0.1;        // -L_yy [1/s]
    double axial_strain = 0.2;      // -ln(hyy/hyy_0) at the end
    double sample_strain = 5e-4;    // between rows
    double modulus = 2e7;           // [Pa], see typical_modulus
    int relax_steps = 2000;
    double dt = 1e-5;
};
struct BiaxialRow : ElementRow {
    double axial_strain = 0;       // eps_a = -ln(hyy/hyy_0)
    double volumetric_strain = 0;  // eps_v = -ln(A/A_0), dilation negative
    double p = 0, q = 0;           // (syy + sxx)/2, (syy - sxx)/2 [Pa]
    double sin_phi = 0;            // q/p
    double inertial_number = 0;    // rate d sqrt(rho/p), d = 10 mm, rho = 2650 kg/m3
};
std::vector<BiaxialRow> run_biaxial(Assembly& sample, const BiaxialTest& test);

// Simple shear at constant mean stress: isotropic compression to `pressure`, then L_xy = rate while a servo
// on the area holds the mean stress. The cell is re-reduced as it skews, so strain has no bound.
struct ShearTest {
    double pressure = 0;          // (sxx + syy)/2, held [Pa]
    double rate = 0.1;            // L_xy [1/s]
    double strain = 1;            // gamma at the end
    double sample_strain = 5e-3;  // between rows
    double modulus = 2e7;         // [Pa], see typical_modulus
    int relax_steps = 2000;
    double dt = 1e-5;
};
struct ShearRow : ElementRow {
    double shear_strain = 0;       // gamma = F_xy/F_yy
    double volumetric_strain = 0;  // eps_v = -ln(A/A_0), dilation negative
    double p = 0, q = 0;           // (s1 + s2)/2, (s1 - s2)/2 [Pa]
    double stress_ratio = 0;       // q/p
    double inertial_number = 0;    // rate d sqrt(rho/p), d = 10 mm, rho = 2650 kg/m3
};
std::vector<ShearRow> run_shear(Assembly& sample, const ShearTest& test);

// k_n/(2 h) of two mean grains [Pa]: the order of a packing's P-wave modulus; scales the servos.
double typical_modulus(std::span<const double> radii, const Material& material);
double typical_modulus(const Packing& packing, const Material& material);

// Rows as CSV with the column names, signs and units of the YADE files, after one '#' line of JSON
// `metadata`. Path and isotropic tests:
//   step,t,Fxx,Fxy,Fyx,Fyy,hxx,hxy,hyx,hyy,sxx,sxy,syx,syy,n,Nc,Z,Zm,phixx,phixy,phiyy,Fa,slide_frac,
//   E_el_n,E_el_t,E_el_r,E_k_trans,E_k_rot,un_max
// Biaxial tests have these and then eps_a,eps_v,p,q,sin_phi,I; shear tests gamma,eps_v,p,q,q_over_p,I.
std::string element_csv(std::span<const ElementRow> rows, const std::string& metadata = "{}");
std::string element_csv(std::span<const BiaxialRow> rows, const std::string& metadata = "{}");
std::string element_csv(std::span<const ShearRow> rows, const std::string& metadata = "{}");

// The largest mobilised friction of a biaxial test up to `strain`: where it was and the angle asin(q/p)
// [rad].
struct PeakFriction {
    double axial_strain = 0;
    double p = 0, q = 0;  // [Pa]
    double friction_angle = 0;
};
PeakFriction peak_friction(std::span<const BiaxialRow> rows, double strain = 0.1);

// One line q = p sin(phi) through the origin, least squares over the peaks of several pressures [rad].
double friction_angle(std::span<const PeakFriction> peaks);

}  // namespace sandgraph::dem

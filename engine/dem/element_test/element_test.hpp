#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "dem/assembly.hpp"
#include "dem/grain_scale.hpp"
#include "dem/time_step.hpp"

namespace sandgraph::dem {

// Element tests: one packing as a soil sample under uniform strain. Strains and stresses are compression
// positive. Keys of test files bind to the members of the tests. `grains`, the scale of the sample's grains,
// sets the servos and what a test leaves at 0: pressure, rate and time step as published for Table 1 grains,
// others in their proportion.

inline constexpr int usual_relax_steps = 2000;  // at L = 0, before a test, not counted in it
inline constexpr double usual_pressure = 64e3;  // held in tests of Table 1 grains [Pa]
inline constexpr double usual_rate = 0.1;       // at which they are strained [1/s]

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
    Mat2 velocity_gradient = Mat2::Zero();
    std::int64_t steps = 0;
};
struct PathTest {
    std::vector<PathSegment> segments;
    int relax_steps = usual_relax_steps;
    int sample_every = 500;              // steps between rows
    double time_step = usual_time_step;  // [s]
};
std::vector<ElementRow> run_path(Assembly& sample, const PathTest& test);

// Isotropic compression (or decompression) to `pressure` [Pa], both normal stresses servo-controlled.
struct IsotropicTest {
    double pressure = 0;      // [Pa]
    double rate = 0;          // largest normal strain rate [1/s]
    double tolerance = 1e-3;  // on both normal stresses, relative
    int relax_steps = usual_relax_steps;
    int sample_every = 500;              // steps between rows
    double time_step = 0;                // [s]
    std::int64_t max_steps = 2'000'000;  // throws std::runtime_error when the pressure is not reached by then
};
std::vector<ElementRow> run_isotropic(Assembly& sample, IsotropicTest test, const GrainScale& grains);
// The same for the sake of the sample: no rows.
void compress(Assembly& sample, IsotropicTest test, const GrainScale& grains);

// Biaxial test: isotropic compression to the confining pressure, then axial shortening along y at a constant
// velocity gradient while a servo on the width holds sigma_xx.
struct BiaxialTest {
    double confining_pressure = 0;  // sigma_xx, held [Pa]
    double axial_rate = 0;          // -L_yy [1/s]
    double axial_strain = 0.2;      // -ln(hyy/hyy_0) at the end
    double strain_every = 5e-4;     // axial strain between rows
    int relax_steps = usual_relax_steps;
    double time_step = 0;  // [s]
};
struct BiaxialRow : ElementRow {
    double axial_strain = 0;       // eps_a = -ln(hyy/hyy_0)
    double volumetric_strain = 0;  // eps_v = -ln(A/A_0), dilation negative
    double p = 0, q = 0;           // (syy + sxx)/2, (syy - sxx)/2 [Pa]
    double sin_phi = 0;            // q/p
    double inertial_number = 0;    // rate d sqrt(rho/p), d the mean diameter, rho of the grains
};
std::vector<BiaxialRow> run_biaxial(Assembly& sample, BiaxialTest test, const GrainScale& grains);

// Simple shear at constant mean stress: isotropic compression to `mean_stress`, then L_xy = shear_rate while
// a servo on the area holds the mean stress. The cell is re-reduced as it skews, so strain has no bound.
struct ShearTest {
    double mean_stress = 0;      // (sxx + syy)/2, held [Pa]
    double shear_rate = 0;       // L_xy [1/s]
    double shear_strain = 0.2;   // gamma at the end
    double strain_every = 5e-4;  // shear strain between rows
    int relax_steps = usual_relax_steps;
    double time_step = 0;  // [s]
};
struct ShearRow : ElementRow {
    double shear_strain = 0;       // gamma = F_xy/F_yy
    double volumetric_strain = 0;  // eps_v = -ln(A/A_0), dilation negative
    double p = 0, q = 0;           // (s1 + s2)/2, (s1 - s2)/2 [Pa]
    double stress_ratio = 0;       // q/p
    double inertial_number = 0;    // rate d sqrt(rho/p), d the mean diameter, rho of the grains
};
std::vector<ShearRow> run_shear(Assembly& sample, ShearTest test, const GrainScale& grains);

// Rows as CSV with the column names, signs and units of the YADE files, after one '#' line of JSON
// `metadata`. Path and isotropic tests:
//   step,t,Fxx,Fxy,Fyx,Fyy,hxx,hxy,hyx,hyy,sxx,sxy,syx,syy,n,Nc,Z,Zm,phixx,phixy,phiyy,Fa,slide_frac,
//   E_el_n,E_el_t,E_el_r,E_k_trans,E_k_rot,un_max
// Biaxial tests have these and then eps_a,eps_v,p,q,sin_phi,I; shear tests gamma,eps_v,p,q,q_over_p,I.
std::string element_csv(std::span<const ElementRow> rows, const std::string& metadata = "{}");
std::string element_csv(std::span<const BiaxialRow> rows, const std::string& metadata = "{}");
std::string element_csv(std::span<const ShearRow> rows, const std::string& metadata = "{}");

// The published programme (Liang et al. 2021, Fig. 2): three confining pressures of Table 1 grains [Pa] (of
// others times their stiffness), the peak within this axial strain.
inline constexpr std::array<double, 3> confining_pressures = {32e3, 64e3, 128e3};
inline constexpr double peak_strain = 0.1;

// The largest mobilised friction of a biaxial test up to `strain`: where it was and the angle asin(q/p)
// [rad].
struct PeakFriction {
    double axial_strain = 0;
    double p = 0, q = 0;  // [Pa]
    double friction_angle = 0;
};
PeakFriction peak_friction(std::span<const BiaxialRow> rows, double strain = peak_strain);

// One line q = p sin(phi) through the origin, least squares over the peaks of several pressures [rad].
double friction_angle(std::span<const PeakFriction> peaks);

}  // namespace sandgraph::dem

#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dem/element_test/element_test.hpp"
#include "dem/prepare/prepare.hpp"
#include "scene/scene.hpp"

namespace sandgraph::laboratory {

// Shear of Table 1 packings (Liang et al. 2021) at constant mean stress until they forget where they came
// from: dense (n = 0.16) and loose (0.20) packings of several seeds at each pressure, on the fast kernel.
struct CriticalPlan {
    std::vector<double> pressures = {2e3, 10e3, 20e3, 80e3, 320e3};  // mean stress held [Pa]
    int seeds = 3;                                                   // 1, 2, ... of each density
    int grains = 400;
    double strain = 10;             // gamma at the end
    double inertial_number = 2e-3;  // sets the rate
    double strain_every = 0.005;    // between rows
};

struct CriticalTest {
    std::string density;
    std::uint64_t seed = 0;
    double pressure = 0;  // [Pa]
    std::vector<dem::ShearRow> rows;
};

// By density, seed and pressure, in this order. The same bits on any number of threads.
std::vector<CriticalTest> test_to_critical_state(const CriticalPlan& plan,
                                                 const ProgressCallback& progress = {});

// Mean over the late half of a test.
struct CriticalState {
    double stress_ratio = 0, porosity = 0, anisotropy = 0, coordination = 0;  // q/p, n, F_a, Z
    double void_ratio() const { return porosity / (1 - porosity); }
};
CriticalState critical_state(const CriticalTest& test);

// Mean and standard deviation of the tests of one density ("" = both) at one pressure.
struct CriticalSpread {
    CriticalState mean, deviation;
    int tests = 0;
};
CriticalSpread critical_spread(const std::vector<CriticalTest>& tests, const std::string& density,
                               double pressure);

// Critical state line e = e_0 - slope p / 100 kPa, least squares over all tests: Li & Wang (1998) with
// exponent 1, since the contacts of this sand are linear. None of tests at one pressure.
struct CriticalLine {
    double e_0 = 0, slope = 0;
};
std::optional<CriticalLine> critical_line(const std::vector<CriticalTest>& tests);

}  // namespace sandgraph::laboratory

#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "dem/element_test/element_test.hpp"
#include "dem/prepare/prepare.hpp"

namespace sandgraph::laboratory {

// A friction testing programme on Table 1 sand (Liang et al. 2021): dense (n = 0.16) and loose (0.20)
// packings of several seeds by our recipes, each in biaxial compression at three confining pressures on the
// fast kernel.
struct LaboratoryPlan {
    int seeds = 5;          // 1, 2, ... of each density
    int grains = 400;       // in a packing
    dem::BiaxialTest test;  // at each of dem::confining_pressures in turn
};

inline constexpr std::array<const char*, 2> kDensities = {"dense", "loose"};

struct Specimen {
    std::string density;
    std::uint64_t seed = 0;
    double porosity = 0, coordination = 0;  // 2D porosity and Z = 2 Nc/N at 10 kPa
    std::array<std::vector<dem::BiaxialRow>, dem::confining_pressures.size()> tests;  // by confining pressure
};

// Dense specimens first, by seed. The same bits on any number of threads.
std::vector<Specimen> test_specimens(const LaboratoryPlan& plan, const ProgressCallback& progress = {});

}  // namespace sandgraph::laboratory

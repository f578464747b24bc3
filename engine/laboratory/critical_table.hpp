#pragma once
#include <string>
#include <vector>

#include "laboratory/critical_state.hpp"

namespace sandgraph::laboratory {

// Late q/p, n, F_a and Z by density and pressure beside the published values, and the critical state line if
// there are two pressures or more.
std::string critical_table(const std::vector<CriticalTest>& tests, const CriticalPlan& plan);

// One row a test: density, seed, pressure [Pa], then the late values.
std::string critical_csv(const std::vector<CriticalTest>& tests);

// All rows of all tests: density, seed, pressure [Pa], gamma, q/p, n, F_a, Z.
std::string critical_curves_csv(const std::vector<CriticalTest>& tests);

}  // namespace sandgraph::laboratory

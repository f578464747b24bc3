#pragma once
#include <string>
#include <vector>

#include "packings/in_situ.hpp"
#include "scene/scene.hpp"
#include "simulation/simulation.hpp"

// What makes the load of an anchor doubtful and is known before the first step.
namespace sandgraph::simulation {

// Past it loads are told, but no breakout is claimed.
inline constexpr double forbidding_rate = 5;

// rho c v sqrt(mass scaling) over gamma H + q: the pressure of the P-wave that the moving plate sends out,
// beside the one that it lies under. Loads come out too high by some 5 % of it (Mohr-Coulomb, H/B 0.5 to 3).
double rate_share(const scene::Scene& scene, const packings::PreparedGround& ground,
                  const Simulation& simulation);

// rho c v sqrt(mass scaling) B [N/m]: the load by which that wave may be carried.
double wave_load(const scene::Scene& scene, const packings::PreparedGround& ground,
                 const Simulation& simulation);

// One line each: a domain narrower than the failure, cells too coarse, a plate too fast, packings too small.
// Empty for a sound scene; of a body without an anchor the cells alone.
std::vector<std::string> caveats(const scene::Scene& scene, const packings::PreparedGround& ground,
                                 const Simulation& simulation);

}  // namespace sandgraph::simulation

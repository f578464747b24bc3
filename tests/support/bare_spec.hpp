#pragma once
#include <functional>

#include "mpm/audit.hpp"
#include "simulation/simulation.hpp"
#include "stress/elastic.hpp"

namespace sandgraph::support {

// The bare equations: no gravity, no damping, no PIC, free sides.
inline simulation::Spec bare_spec(const mpm::GridShape& grid) {
    simulation::Spec spec;
    spec.grid = grid;
    spec.boundaries = {};
    spec.gravity = Vec2::Zero();
    spec.scheme.damping = spec.scheme.pic_fraction = 0;
    return spec;
}

// An elastic law, each point under `initial(points, p)` [Pa]; stress-free without it.
inline simulation::LawFactory elastic(
    const stress::ElasticConstants& constants,
    const std::function<Stress(const mpm::Points&, std::size_t)>& initial = {}) {
    return [=](const mpm::Points& points) {
        std::vector<Stress> start(points.size());
        for (std::size_t p = 0; initial && p < points.size(); ++p) start[p] = initial(points, p);
        return std::make_unique<stress::Elastic>(constants, std::move(start));
    };
}

inline void steps(simulation::Simulation& simulation, int count) {
    for (int k = 0; k < count; ++k) simulation.step();
}

}  // namespace sandgraph::support

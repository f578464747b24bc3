#include "simulation/make_frame.hpp"

#include <fmt/ranges.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <limits>
#include <map>

#include "dem/rve.hpp"
#include "graph/screening/modes.hpp"

namespace sandgraph::simulation {
namespace {

template <class Value>
io::Field field(const char* name, const char* unit, int components, std::size_t points, Value value,
                const char* component_names = "") {
    io::Field out{name, unit, components, {}, component_names};
    out.values.reserve(points * static_cast<std::size_t>(components));
    for (std::size_t p = 0; p < points; ++p)
        for (const double v : value(p)) out.values.push_back(v);
    return out;
}

constexpr const char* kSymmetric = "xx yy xy";

using One = std::array<double, 1>;
using Two = std::array<double, 2>;
using Three = std::array<double, 3>;
using Four = std::array<double, 4>;

// Of every point; points that still share their row's packing are looked at once.
std::vector<dem::Observables> observe_all(const stress::Law& law, const dem::Material& material,
                                          std::size_t n) {
    std::map<const dem::CompactPacking*, dem::Observables> shared;
    std::vector<dem::Observables> out(n);
    const auto rve = [&](std::size_t p) -> const dem::Rve& { return *law.observe(p).packing; };
    tbb::parallel_for(std::size_t{0}, n, [&](std::size_t p) {
        if (rve(p).owns_packing()) out[p] = dem::observe(rve(p), material);
    });
    for (std::size_t p = 0; p < n; ++p) {
        if (rve(p).owns_packing()) continue;
        const auto [place, fresh] = shared.try_emplace(&rve(p).packing());
        if (fresh) place->second = dem::observe(rve(p), material);
        out[p] = place->second;
    }
    return out;
}

void add_grain_fields(const stress::Law& law, const dem::Material& material, std::size_t n,
                      io::Frame& frame) {
    frame.fields.push_back(field("owns packing", "-", 1, n, [&](std::size_t p) {
        return One{double(law.observe(p).packing->owns_packing())};
    }));
    const std::vector<dem::Observables> seen = observe_all(law, material, n);
    frame.fields.push_back(field(
        "fabric", "-", 3, n,
        [&](std::size_t p) {
            return Three{seen[p].fabric(0, 0), seen[p].fabric(1, 1), seen[p].fabric(0, 1)};
        },
        kSymmetric));
    frame.fields.push_back(
        field("fabric anisotropy", "-", 1, n, [&](std::size_t p) { return One{seen[p].anisotropy}; }));
    frame.fields.push_back(
        field("coordination number", "-", 1, n, [&](std::size_t p) { return One{seen[p].coordination}; }));
}

void add_screening_fields(const stress::Law& law, std::size_t n, io::Frame& frame) {
    frame.fields.push_back(
        field("mode", "-", 1, n, [&](std::size_t p) { return One{double(law.observe(p).mode)}; }));
    frame.fields.back().codes = fmt::format("{}", fmt::join(graph::mode_names, " "));
    frame.fields.push_back(
        field("audited error", "-", 1, n, [&](std::size_t p) { return One{law.observe(p).audited_error}; }));
}

// NaN in ground without a body.
Vec2 anchor_centre(const graph::GroundState& s) {
    if (s.bodies.empty()) return Vec2::Constant(std::numeric_limits<double>::quiet_NaN());
    return {s.bodies.front().plate.x, s.bodies.front().plate.y};
}

}  // namespace

double point_porosity(const graph::GroundState& s, std::size_t point, double initial_porosity) {
    const double known = s.law->observe(point).porosity;
    if (!std::isnan(known)) return known;
    return 1 - (1 - initial_porosity) * s.points.volume0[point] / s.points.volume[point];
}

io::Frame make_frame(const Simulation& simulation, const std::vector<Vec2>& start, double initial_porosity,
                     const dem::Material& material) {
    const graph::GroundState& s = simulation.state();
    const mpm::Points& g = s.points;
    const std::size_t n = g.size();
    const Vec2 plate = anchor_centre(s);
    io::Frame frame{simulation.time(), simulation.d_over_B(), plate.x(), plate.y(), g.x, g.y, {}};
    frame.fields.push_back(field(
        "displacement", "m", 2, n,
        [&](std::size_t p) {
            return Two{g.x[p] - start[p].x(), g.y[p] - start[p].y()};
        },
        io::plane_vector));
    frame.fields.push_back(field(
        "velocity", "m/s", 2, n,
        [&](std::size_t p) {
            return Two{g.vx[p], g.vy[p]};
        },
        io::plane_vector));
    frame.fields.push_back(field(
        "F", "-", 4, n,
        [&](std::size_t p) {
            return Four{g.F[p](0, 0), g.F[p](0, 1), g.F[p](1, 0), g.F[p](1, 1)};
        },
        "xx xy yx yy"));
    frame.fields.push_back(field(
        "stress", "Pa", 3, n,
        [&](std::size_t p) {
            return Three{-g.stress[p].xx, -g.stress[p].yy, -g.stress[p].xy};
        },
        kSymmetric));
    frame.fields.push_back(
        field("p", "Pa", 1, n, [&](std::size_t p) { return One{mean_stress(g.stress[p])}; }));
    frame.fields.push_back(field("q", "Pa", 1, n, [&](std::size_t p) { return One{deviator(g.stress[p])}; }));
    frame.fields.push_back(field("porosity", "-", 1, n,
                                 [&](std::size_t p) { return One{point_porosity(s, p, initial_porosity)}; }));
    if (s.law->answers() == stress::Answers::grains) add_grain_fields(*s.law, material, n, frame);
    if (s.law->answers() == stress::Answers::screening) add_screening_fields(*s.law, n, frame);
    return frame;
}

}  // namespace sandgraph::simulation

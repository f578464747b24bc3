#include "simulation/make_frame.hpp"

#include <tbb/parallel_for.h>

#include <map>

#include "graph/screening_law.hpp"
#include "simulation/point_sight.hpp"

namespace sandgraph::simulation {
namespace {

template <class Value>
io::Field field(const char* name, const char* unit, int components, std::size_t points, Value value) {
    io::Field out{name, unit, components, {}};
    out.values.reserve(points * static_cast<std::size_t>(components));
    for (std::size_t p = 0; p < points; ++p)
        for (const double v : value(p)) out.values.push_back(v);
    return out;
}

using One = std::array<double, 1>;
using Two = std::array<double, 2>;
using Three = std::array<double, 3>;
using Four = std::array<double, 4>;

// Of every point; points that still share their row's packing are looked at once.
std::vector<dem::Observables> observe_all(const graph::RveLaw& law, std::size_t n) {
    std::map<const dem::CompactPacking*, dem::Observables> shared;
    std::vector<dem::Observables> out(n);
    tbb::parallel_for(std::size_t{0}, n, [&](std::size_t p) {
        if (law.rve(p).owns_packing()) out[p] = law.observe(p);
    });
    for (std::size_t p = 0; p < n; ++p) {
        if (law.rve(p).owns_packing()) continue;
        const auto [place, fresh] = shared.try_emplace(&law.rve(p).packing());
        if (fresh) place->second = law.observe(p);
        out[p] = place->second;
    }
    return out;
}

void add_fabric(const graph::RveLaw& law, std::size_t n, io::Frame& frame) {
    const std::vector<dem::Observables> seen = observe_all(law, n);
    frame.fields.push_back(field("fabric", "-", 3, n, [&](std::size_t p) {
        return Three{seen[p].fabric(0, 0), seen[p].fabric(1, 1), seen[p].fabric(0, 1)};
    }));
    frame.fields.push_back(
        field("fabric anisotropy", "-", 1, n, [&](std::size_t p) { return One{seen[p].anisotropy}; }));
    frame.fields.push_back(
        field("coordination number", "-", 1, n, [&](std::size_t p) { return One{seen[p].coordination}; }));
}

void add_rve_fields(const graph::RveLaw& law, std::size_t n, io::Frame& frame) {
    frame.fields.push_back(field("owns packing", "-", 1, n,
                                 [&](std::size_t p) { return One{double(law.rve(p).owns_packing())}; }));
    add_fabric(law, n, frame);
}

void add_screening_fields(const graph::ScreeningLaw& law, std::size_t n, io::Frame& frame) {
    frame.fields.push_back(
        field("mode", "-", 1, n, [&](std::size_t p) { return One{static_cast<double>(law.mode(p))}; }));
    frame.fields.push_back(
        field("audited error", "-", 1, n, [&](std::size_t p) { return One{law.audited_error(p)}; }));
}

}  // namespace

io::Frame make_frame(const graph::Pull& pull, const std::vector<Vec2>& start, double initial_porosity) {
    const graph::GroundState& s = pull.state();
    const mpm::Points& g = s.points;
    const std::size_t n = g.size();
    io::Frame frame{pull.time(), pull.d_over_B(), s.plate.x, s.plate.y, g.x, g.y, {}};
    frame.fields.push_back(field("displacement", "m", 2, n, [&](std::size_t p) {
        return Two{g.x[p] - start[p].x(), g.y[p] - start[p].y()};
    }));
    frame.fields.push_back(field("F", "-", 4, n, [&](std::size_t p) {
        return Four{g.F[p](0, 0), g.F[p](0, 1), g.F[p](1, 0), g.F[p](1, 1)};
    }));
    frame.fields.push_back(field("stress", "Pa", 3, n, [&](std::size_t p) {
        return Three{-g.stress[p].xx, -g.stress[p].yy, -g.stress[p].xy};
    }));
    frame.fields.push_back(
        field("p", "Pa", 1, n, [&](std::size_t p) { return One{mean_stress(g.stress[p])}; }));
    frame.fields.push_back(field("q", "Pa", 1, n, [&](std::size_t p) { return One{deviator(g.stress[p])}; }));
    frame.fields.push_back(field("porosity", "-", 1, n, [&](std::size_t p) {
        return One{point_porosity(pull, p, initial_porosity)};
    }));
    if (const auto* rve = dynamic_cast<const graph::RveLaw*>(s.law.get()))
        add_rve_fields(*rve, n, frame);
    else if (const auto* screening = dynamic_cast<const graph::ScreeningLaw*>(s.law.get()))
        add_screening_fields(*screening, n, frame);
    return frame;
}

}  // namespace sandgraph::simulation

#include "small_pull.hpp"

#include <fmt/format.h>

#include <numbers>

#include "dem/fast.hpp"
#include "dem/observe.hpp"
#include "mpm/layout.hpp"
#include "mpm/time_step.hpp"

namespace sandgraph::support {
namespace {

constexpr double kCell = 0.25, kWidth = 2, kDepth = 2, kGravity = 9.81;

dem::AssemblyFactory fast() {
    return [](const dem::Packing& p, const dem::Material& m) {
        return std::make_unique<dem::FastAssembly>(p, m);
    };
}

const dem::Packing& base() {
    static const dem::Packing packing = dem::prepare({.grains = 100}, dem::Material{}, fast()).packing;
    return packing;
}

graph::RowPacking row_packing(double pressure) {
    const dem::Material material;
    const dem::Packing p = dem::compress_to(base(), {.pressure = pressure}, material, fast());
    const Mat2 stress = dem::love_weber_stress(p, dem::contact_forces(p, material), material);
    return {dem::compact(p, material, stress), {2e7, 1.4e7}};
}

const std::vector<graph::RowPacking>& rows() {
    static const std::vector<graph::RowPacking> made = [] {
        std::vector<graph::RowPacking> out;
        for (double depth = 0.5 * kCell; depth < kDepth; depth += kCell)
            out.push_back(row_packing(2230 * kGravity * depth));
        return out;
    }();
    return made;
}

}  // namespace

std::unique_ptr<graph::Pull> small_pull() {
    mpm::RigidPlate plate;
    plate.y = 0.875, plate.half_width = 0.5, plate.half_height = 0.125;
    plate.friction_angle = std::numbers::pi / 2;
    mpm::Layout layout{{0, 0, kWidth, kDepth}, kCell, 1, 2230, {plate.rectangle()}};
    mpm::Points points = mpm::lay_out(layout);
    auto law = std::make_unique<graph::RveLaw>(graph::RveLawSetup{{}, {}, rows(), points.row});
    const double modulus = law->p_wave_modulus();
    graph::StepSettings settings;
    settings.dt = mpm::time_step({0.3, kCell, modulus, 2230, 1, 1});
    settings.pic = 0.01, settings.damping = 0.05, settings.gravity = kGravity;
    settings.boundaries = {mpm::Side::mirror, mpm::Side::mirror, mpm::Side::fixed, mpm::Side::free};
    auto state =
        std::make_unique<graph::GroundState>(settings, std::move(points), mpm::GridShape{0, 0, kCell, 8, 14});
    state->has_plate = true;
    plate.stiffness = mpm::contact_stiffness(1, modulus, kCell);
    const double gamma = 2230 * kGravity, pressure = gamma * (kDepth - plate.y);
    plate.rest = {pressure, pressure, gamma, gamma};
    state->plate = plate;
    state->law = std::move(law);
    state->law->initialise(state->batch());
    return std::make_unique<graph::Pull>(std::move(state), graph::PullPlan{.settle = 0.002});
}

std::string digest(const graph::Pull& pull) {
    const mpm::Points& g = pull.state().points;
    std::string out = fmt::format("{:a} {:a}\n", pull.load(), pull.state().stress_work);
    for (std::size_t p = 0; p < g.size(); ++p)
        out += fmt::format("{:a} {:a} {:a} {:a} {:a} {:a} {:a}\n", g.x[p], g.y[p], g.vx[p], g.vy[p],
                           g.stress[p].xx, g.stress[p].yy, g.stress[p].xy);
    return out;
}

}  // namespace sandgraph::support

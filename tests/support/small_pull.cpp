#include "small_pull.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "dem/fast/fast.hpp"
#include "dem/packing/observe.hpp"
#include "element_surrogate.hpp"
#include "graph/screening/law.hpp"
#include "table1_options.hpp"

namespace sandgraph::support {
namespace {

constexpr double kCell = 0.25, kGravity = 9.81, kDensity = 2230;
constexpr double kPlateDepth = 1.125;  // of its centre [m]

// Of the ground, in cells.
struct Extent {
    int columns, rows;
};
constexpr Extent small{8, 8}, wide{32, 64};

dem::AssemblyFactory fast() {
    return [](const dem::Packing& p, const dem::Material& m) {
        return std::make_unique<dem::FastAssembly>(p, m);
    };
}

const dem::Packing& base() {
    static const dem::Packing packing = dem::prepare({.count = 100}, dem::Material{}, fast()).packing;
    return packing;
}

graph::RowPacking row_packing(double pressure) {
    const dem::Material material;
    const dem::Packing p = dem::compress_to(base(), {.pressure = pressure}, material, fast());
    const Mat2 stress = dem::love_weber_stress(p, dem::contact_forces(p, material), material);
    return {dem::compact(p, material, stress), {2e7, 1.4e7}};
}

// From the surface down, `count` of them at least.
const std::vector<graph::RowPacking>& rows(int count) {
    static std::vector<graph::RowPacking> made;
    while (std::ssize(made) < count)
        made.push_back(row_packing(kDensity * kGravity * kCell * (static_cast<double>(made.size()) + 0.5)));
    return made;
}

using LawMaker = std::unique_ptr<stress::Law> (*)(const mpm::Points&, const graph::PoolMaker&);

graph::RveLawSetup grains_of(const mpm::Points& points, const graph::PoolMaker& make_pool) {
    const int count = 1 + *std::ranges::max_element(points.row);
    const auto all = rows(count);
    return {{}, table1_options(), {all.begin(), all.begin() + count}, points.row, {}, make_pool};
}

std::unique_ptr<stress::Law> full_law(const mpm::Points& points, const graph::PoolMaker& make_pool) {
    return std::make_unique<graph::RveLaw>(grains_of(points, make_pool));
}

// Updates go on in the next steps, bounds and settling follow what the packing did before.
std::unique_ptr<stress::Law> carrying_law(const mpm::Points& points, const graph::PoolMaker& make_pool) {
    graph::RveLawSetup setup = grains_of(points, make_pool);
    setup.options.steps_max = 4, setup.options.rate_jump_max = 2;
    setup.options.steady_factor = 2, setup.options.steady_strain = 1e-5;
    setup.visits = {
        .update_tolerance = 0.005, .update_change_max = 0.2, .predictor = graph::Predictor::secant};
    return std::make_unique<graph::RveLaw>(std::move(setup));
}

std::unique_ptr<stress::Law> screening_law(const mpm::Points& points, const graph::PoolMaker& make_pool) {
    graph::ScreeningSetup setup;
    setup.grains = grains_of(points, make_pool);
    setup.surrogate = std::make_shared<ElementSurrogate>();
    for (const graph::RowPacking& row : setup.grains.packings) {
        const double p = mean_stress(tension_positive(row.packing->stress));
        setup.traits.push_back({p, 0.16, row.moduli.bulk, row.moduli.shear, 3.5, 0, 0, 0.5});
    }
    setup.gate.strain = 5e-5, setup.gate.flow = 2e-4;
    setup.hand_over.blend_steps = 20;
    setup.audit = {0.25, 1, 1e-4};
    return std::make_unique<graph::ScreeningLaw>(std::move(setup));
}

std::unique_ptr<simulation::Simulation> pull_with(const Extent& extent, LawMaker law,
                                                  const graph::PoolMaker& make_pool = graph::local_pool) {
    const double depth = extent.rows * kCell;
    mpm::RigidPlate plate{0, depth - kPlateDepth, 0.5, 0.125};
    plate.friction_angle = std::numbers::pi / 2;
    plate.rest = mpm::rest_pressure(0, kDensity * kGravity, kPlateDepth);
    simulation::Spec spec;
    spec.ground.extent = {0, 0, extent.columns * kCell, depth};
    spec.ground.density = kDensity;
    spec.grid = {0, 0, kCell, extent.columns, extent.rows + 6};
    spec.gravity = {0, -kGravity};
    spec.bodies = {{plate, {.rate = 0.05, .ramp = 0.01, .settle = 0.002}}};
    spec.law = [law, make_pool](const mpm::Points& points) { return law(points, make_pool); };
    return std::make_unique<simulation::Simulation>(spec);
}

}  // namespace

std::unique_ptr<simulation::Simulation> small_pull() { return pull_with(small, full_law); }
std::unique_ptr<simulation::Simulation> small_screening_pull() { return pull_with(small, screening_law); }
std::unique_ptr<simulation::Simulation> small_carrying_pull() { return pull_with(small, carrying_law); }
std::unique_ptr<simulation::Simulation> wide_pull() { return pull_with(wide, full_law); }

std::unique_ptr<simulation::Simulation> small_pull_in(SmallPull kind, const graph::PoolMaker& make_pool) {
    constexpr LawMaker laws[] = {full_law, carrying_law, screening_law};
    return pull_with(small, laws[static_cast<int>(kind)], make_pool);
}

std::string digest(const simulation::Simulation& pull) {
    const mpm::Points& g = pull.state().points;
    std::string out = fmt::format("{:a} {:a}\n", pull.load(), pull.state().stress_work);
    if (const auto* law = dynamic_cast<const graph::ScreeningLaw*>(pull.state().law.get())) {
        for (std::size_t p = 0; p < law->size(); ++p)
            out += fmt::format("{} {:a} ", static_cast<int>(law->modes()[p]), law->observe(p).audited_error);
        for (const stress::Switch& s : law->screening_log()->switches)
            out += fmt::format("{} {} {:a}\n", s.step, s.point, s.jump);
        for (const stress::AuditRow& a : law->screening_log()->audits)
            out += fmt::format("{:a} {:a}\n", a.mean, a.ci95);
        out += fmt::format("{} {:a}\n", law->grain_use().dem_steps, law->screening_log()->counters.jump_work);
    }
    for (std::size_t p = 0; p < g.size(); ++p)
        out += fmt::format("{:a} {:a} {:a} {:a} {:a} {:a} {:a}\n", g.x[p], g.y[p], g.vx[p], g.vy[p],
                           g.stress[p].xx, g.stress[p].yy, g.stress[p].xy);
    return out;
}

}  // namespace sandgraph::support

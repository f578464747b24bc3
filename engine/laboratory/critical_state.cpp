#include "laboratory/critical_state.hpp"

#include <tbb/parallel_for.h>

#include <cmath>

#include "base/console.hpp"
#include "dem/make_assembly.hpp"
#include "laboratory/soil_laboratory.hpp"
#include "packings/base_packing.hpp"

namespace sandgraph::laboratory {
namespace {

constexpr const char* kStage = "packings and shear tests";

std::vector<CriticalTest> planned(const CriticalPlan& plan) {
    std::vector<CriticalTest> tests;
    for (const char* density : kDensities)
        for (int seed = 1; seed <= plan.seeds; ++seed)
            for (const double pressure : plan.pressures)
                tests.push_back({density, static_cast<std::uint64_t>(seed), pressure, {}});
    return tests;
}

void shear(CriticalTest& test, const dem::Packing& packing, const CriticalPlan& plan) {
    const dem::Material material;
    const dem::Recipe grains;  // its mean diameter: the same rate for all packings
    const double diameter = grains.radius_min + grains.radius_max;
    const double rate = plan.inertial_number * std::sqrt(test.pressure / material.density) / diameter;
    const dem::ShearTest shear{.mean_stress = test.pressure,
                               .shear_rate = rate,
                               .shear_strain = plan.strain,
                               .strain_every = plan.strain_every};
    test.rows = dem::run_shear(*dem::fast_assemblies()(packing, material), shear,
                               dem::grain_scale(packing, material));
}

template <class Figure>
void each_figure(Figure&& figure) {
    for (double CriticalState::*member : {&CriticalState::stress_ratio, &CriticalState::porosity,
                                          &CriticalState::anisotropy, &CriticalState::coordination})
        figure(member);
}

}  // namespace

std::vector<CriticalTest> test_to_critical_state(const CriticalPlan& plan, const ProgressCallback& progress) {
    std::vector<CriticalTest> tests = planned(plan);
    const std::size_t pressures = plan.pressures.size(), packings = tests.size() / pressures;
    Tally tally(tests.size() + packings, progress);
    tbb::parallel_for(std::size_t{0}, packings, [&](std::size_t k) {
        CriticalTest* own = &tests[k * pressures];
        const dem::Packing packing = packings::table1_packing(own->density, own->seed, plan.grains);
        tally.done(kStage);
        tbb::parallel_for(std::size_t{0}, pressures, [&](std::size_t t) {
            shear(own[t], packing, plan);
            tally.done(kStage);
        });
    });
    return tests;
}

CriticalState critical_state(const CriticalTest& test) {
    CriticalState sum;
    double count = 0;
    for (const dem::ShearRow& row : test.rows) {
        if (2 * row.shear_strain < test.rows.back().shear_strain) continue;
        sum.stress_ratio += row.stress_ratio, sum.porosity += row.seen.porosity;
        sum.anisotropy += row.seen.anisotropy, sum.coordination += row.seen.coordination;
        ++count;
    }
    each_figure([&](auto member) { sum.*member /= count; });
    return sum;
}

CriticalSpread critical_spread(const std::vector<CriticalTest>& tests, const std::string& density,
                               double pressure) {
    std::vector<CriticalState> states;
    for (const CriticalTest& test : tests)
        if (test.pressure == pressure && (density.empty() || test.density == density))
            states.push_back(critical_state(test));
    CriticalSpread out;
    out.tests = static_cast<int>(states.size());
    each_figure([&](auto member) {
        for (const CriticalState& s : states) out.mean.*member += s.*member / out.tests;
        for (const CriticalState& s : states)
            out.deviation.*member += std::pow(s.*member - out.mean.*member, 2);
        out.deviation.*member = out.tests > 1 ? std::sqrt(out.deviation.*member / (out.tests - 1)) : 0;
    });
    return out;
}

std::optional<CriticalLine> critical_line(const std::vector<CriticalTest>& tests) {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (const CriticalTest& test : tests) {
        const double p = test.pressure / 100e3, e = critical_state(test).void_ratio();
        ++n, x += p, y += e, xx += p * p, xy += p * e;
    }
    const double spread = n * xx - x * x;
    if (!(spread > 1e-9 * n * xx)) return std::nullopt;  // equal pressures leave round-off
    const double slope = -(n * xy - x * y) / spread;
    return CriticalLine{(y + slope * x) / n, slope};
}

}  // namespace sandgraph::laboratory

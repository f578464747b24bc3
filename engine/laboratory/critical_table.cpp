#include "laboratory/critical_table.hpp"

#include <fmt/format.h>

#include "laboratory/soil_laboratory.hpp"

namespace sandgraph::laboratory {
namespace {

std::string figure(double mean, double deviation, int decimals) {
    return fmt::format("{:>9.{}f} +- {:<6.{}f}", mean, decimals, deviation, decimals);
}

std::string line(const std::string& name, double pressure, const CriticalSpread& s) {
    return fmt::format("{:<8}{:>6g} kPa{:>4}", name, pressure / 1e3, s.tests) +
           figure(s.mean.stress_ratio, s.deviation.stress_ratio, 3) +
           figure(s.mean.porosity, s.deviation.porosity, 4) +
           figure(s.mean.anisotropy, s.deviation.anisotropy, 3) +
           figure(s.mean.coordination, s.deviation.coordination, 2) + "\n";
}

std::string name(const CriticalTest& t) { return fmt::format("{},{},{:g}", t.density, t.seed, t.pressure); }

}  // namespace

std::string critical_table(const std::vector<CriticalTest>& tests, const CriticalPlan& plan) {
    std::string text = fmt::format(
        "simple shear at constant mean stress, I = {:g}; means over {:g} to {:g} % strain\n"
        "{:<8}{:>10}{:>4}{:>12}{:>19}{:>19}{:>17}\n",
        plan.inertial_number, 50 * plan.strain, 100 * plan.strain, "", "pressure", "", "q/p", "n", "F_a",
        "Z");
    for (const double pressure : plan.pressures)
        for (const char* density : kDensities)
            text += line(density, pressure, critical_spread(tests, density, pressure));
    text += "published near 20 kPa (Liang et al. 2021): q/p 0.36, n 0.206, F_a 0.32\n";
    if (const auto csl = critical_line(tests))
        text += fmt::format("critical state line: e = {:.4f} - {:.5f} p / 100 kPa\n", csl->e_0, csl->slope);
    return text;
}

std::string critical_csv(const std::vector<CriticalTest>& tests) {
    std::string text = "density,seed,pressure,q_over_p,porosity,void_ratio,anisotropy,coordination\n";
    for (const CriticalTest& test : tests) {
        const CriticalState s = critical_state(test);
        text += fmt::format("{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}\n", name(test), s.stress_ratio, s.porosity,
                            s.void_ratio(), s.anisotropy, s.coordination);
    }
    return text;
}

std::string critical_curves_csv(const std::vector<CriticalTest>& tests) {
    std::string text = "density,seed,pressure,gamma,q_over_p,porosity,anisotropy,coordination\n";
    for (const CriticalTest& test : tests)
        for (const dem::ShearRow& row : test.rows)
            text +=
                fmt::format("{},{:.5g},{:.5g},{:.6g},{:.5g},{:.5g}\n", name(test), row.shear_strain,
                            row.stress_ratio, row.seen.porosity, row.seen.anisotropy, row.seen.coordination);
    return text;
}

}  // namespace sandgraph::laboratory

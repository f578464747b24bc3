#include "results/budget.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/statistics.hpp"

namespace sandgraph::results {
namespace {

// First-order errors go straight on to cells of no size within this (docs/verification.md, two grids), and
// what a run tells of its drag is right within this share of it (docs/accuracy.md).
constexpr double kMeshLeast = 0.025, kToldRight = 0.25;

double unknown() { return std::numeric_limits<double>::quiet_NaN(); }

BudgetItem of_packings(const std::vector<double>& coarse) {
    const Sample s = sample_of(coarse);
    return {"packings", s.mean / coarse.front() - 1, s.ci95 / s.mean,
            fmt::format("mean of {} packings on coarse cells, they scatter by {:.1f} %", s.count,
                        100 * s.deviation / s.mean)};
}

BudgetItem of_mesh(const BudgetLoads& loads, double book) {
    if (std::isfinite(loads.fine) && !loads.coarse.empty()) {
        const double correction = 1 - loads.coarse.front() / loads.fine;
        return {"mesh", correction, std::max(kMeshLeast, 0.5 * std::fabs(correction)),
                "two grids, straight on to cells of no size"};
    }
    if (std::isfinite(book))
        return {"mesh", -book, std::max(kMeshLeast, 0.5 * std::fabs(book)),
                "no second grid holds this scene: by cases with an exact load"};
    return {"mesh", 0, unknown(), "not known: no second grid holds this scene, nor has it an exact case"};
}

// What half the rate leaves out is half of what a wave takes; the scatter of the packing hides little of it.
BudgetItem of_rate(const BudgetLoads& loads, double told) {
    const double drag = std::isfinite(told) ? told : 0;
    if (!std::isfinite(loads.slow) || loads.coarse.empty())
        return {"rate", -drag, std::max(0.01, kToldRight * drag),
                "damping, PIC and inertia as the run tells"};
    const double seen = 2 * (1 - loads.slow / loads.coarse.front());
    return {"rate", -drag, std::max(kToldRight * drag, 0.5 * std::fabs(seen - drag)),
            fmt::format("as the run tells; half the rate says {:+.1f} %", -100 * seen)};
}

BudgetItem of_surrogate(const BudgetLoads& loads) {
    const double correction = loads.grains / loads.coarse.front() - 1;
    return {"surrogate", correction, std::max(0.01, 0.5 * std::fabs(correction)),
            "full fidelity on coarse cells"};
}

nlohmann::ordered_json number(double value) {
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

}  // namespace

double Budget::corrected() const {
    double factor = 1;
    for (const BudgetItem& item : items) factor *= 1 + item.correction;
    return load * factor;
}

double Budget::ci95() const {  // docs/how_it_works.md (eq. 45c)
    double sum = 0;
    for (const BudgetItem& item : items) sum += std::isfinite(item.ci95) ? item.ci95 * item.ci95 : 0;
    return corrected() * std::sqrt(sum);
}

std::vector<BudgetItem> budget_items(const BudgetLoads& loads, double told, double book) {
    std::vector<BudgetItem> items;
    if (loads.coarse.size() > 1) items.push_back(of_packings(loads.coarse));
    items.push_back(of_mesh(loads, book));
    items.push_back(of_rate(loads, told));
    if (std::isfinite(loads.grains) && !loads.coarse.empty()) items.push_back(of_surrogate(loads));
    return items;
}

std::string to_json(const Budget& b) {
    nlohmann::ordered_json json;
    json["load_N_per_m"] = number(b.load), json["breakout"] = b.breakout;
    json["corrected_load_N_per_m"] = number(b.corrected()), json["ci95_N_per_m"] = number(b.ci95());
    json["corrected_n_gamma"] = number(b.corrected() / b.unit_load);
    json["n_gamma_ci95"] = number(b.ci95() / b.unit_load);
    for (const BudgetItem& item : b.items)
        json["items"].push_back({{"source", item.source},
                                 {"correction", number(item.correction)},
                                 {"ci95", number(item.ci95)},
                                 {"correction_N_per_m", number(item.correction * b.load)},
                                 {"ci95_N_per_m", number(item.ci95 * b.load)},
                                 {"how", item.how}});
    json["cost"] = number(b.cost);
    return json.dump(2) + "\n";
}

std::string budget_text(const Budget& b) {
    std::string text = fmt::format("{:<10} {:>21} {:>23}\n", "", "correction", "95 %");
    for (const BudgetItem& i : b.items)
        text += fmt::format("{:<10} {:>+8.1f} % {:>+6.2f} kN/m {:>8} {:>7.1f} % {:>5.2f} kN/m   {}\n",
                            i.source, 100 * i.correction, i.correction * b.load / 1e3, "+-", 100 * i.ci95,
                            i.ci95 * b.load / 1e3, i.how);
    text +=
        fmt::format("{} {:.4g} kN/m; corrected {:.4g} +- {:.2g} kN/m, N_gamma {:.3g} +- {:.2g}\n",
                    b.breakout ? "breakout load" : "no breakout; largest load", b.load / 1e3,
                    b.corrected() / 1e3, b.ci95() / 1e3, b.corrected() / b.unit_load, b.ci95() / b.unit_load);
    return text + fmt::format("cost {:.2f} times the scene's own run\n", b.cost);
}

}  // namespace sandgraph::results

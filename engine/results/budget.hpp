#pragma once
#include <limits>
#include <string>
#include <vector>

// A breakout load with what is known of its errors: packings, mesh, rate of pull, surrogate.
namespace sandgraph::results {

// One source of error, as shares of the load.
struct BudgetItem {
    std::string source;
    double correction = 0;  // to be added to the load
    double ci95 =
        std::numeric_limits<double>::quiet_NaN();  // half of the correction's interval; NaN: not known
    std::string how;                               // one line
};

struct Budget {
    double load = 0, unit_load = 0;  // of the scene's own run, of the whole plate; B (gamma H + q) [N/m]
    bool breakout = true;            // false: `load` is the largest reached
    std::vector<BudgetItem> items;
    double cost = 0;  // processor time of all runs, as a multiple of that of the scene's own

    double corrected() const;  // load with all corrections [N/m]
    double ci95() const;       // half of its interval, of the items' that are known [N/m]
};

// Loads of the runs of a budget [N/m]. `fine` and `coarse` are of one geometry that both grids know and of
// the first packing; empty or NaN: there is no such run.
struct BudgetLoads {
    double fine = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> coarse;                              // by packing, the scene's own seed first
    double slow = std::numeric_limits<double>::quiet_NaN();  // coarse, at half the rate
    double grains =
        std::numeric_limits<double>::quiet_NaN();  // coarse, at full fidelity beside a screening run
};

// docs/how_it_works.md (eqs. 45 to 45c). `told`: share of the load that the scene's run says damping, PIC and
// inertia carry; `book`: mesh error by cases with an exact load, for a scene without a second grid.
std::vector<BudgetItem> budget_items(const BudgetLoads& loads, double told, double book);

std::string to_json(const Budget& budget);
std::string budget_text(const Budget& budget);

}  // namespace sandgraph::results

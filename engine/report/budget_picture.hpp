#pragma once
#include "report/gnuplot.hpp"
#include "results/budget.hpp"

namespace sandgraph::report {

// The load, then each correction in turn with its interval, and what comes of all [kN/m].
Plot budget_plot(const results::Budget& budget, const std::string& title);

Picture draw_budget_picture(const results::Budget& budget, const std::string& title,
                            const std::filesystem::path& png);

}  // namespace sandgraph::report

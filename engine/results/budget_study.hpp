#pragma once
#include <optional>
#include <string>
#include <vector>

#include "results/budget.hpp"
#include "results/kept_run.hpp"

// The runs behind the error budget of a scene's breakout load.
namespace sandgraph::results {

struct BudgetRequest {
    simulation::RunRequest run;  // `folder` holds all runs
    int samples = 4;             // packings drawn on coarse cells, at least 2
    DrawPictures draw;
};

// Settings for a scene whose faces both its grid and one of twice the cell can hold: a thicker plate, moved
// by less than a cell, in a domain no smaller. Empty: the scene is such a one; nothing: there are none.
std::optional<std::vector<std::string>> shared_geometry(const simulation::RunRequest& request);

// Makes the runs, or finds them made. Empty when one was stopped; InputError for a scene without an anchor.
std::optional<Budget> budget(const BudgetRequest& request);

}  // namespace sandgraph::results

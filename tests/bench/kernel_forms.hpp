#pragma once
#include <functional>
#include <string>
#include <vector>

#include "dem/fast/kernel.hpp"
#include "dem/fast/state.hpp"

namespace sandgraph::dem::bench {

double seconds();    // processor time of this thread
double clock_GHz();  // of a chain of additions, one a cycle

// Median time of each [s], measured in turn.
std::vector<double> medians(const std::vector<std::function<void()>>& runs);

// A packing a little way into simple shear, its list fresh; `later` is the same a little further.
struct Sheared {
    FastState state, later;
    double rebuild_share = 0;  // of the time in shear
    double steps_per_rebuild = 0;
    explicit Sheared(const std::string& packing_csv);
    int contacts() const;
};

// Instructions, cycles and bytes of the kernel, by contact and by step.
void print_machine(const Sheared& sheared, double clock, int contacts);

}  // namespace sandgraph::dem::bench

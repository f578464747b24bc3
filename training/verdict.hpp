#pragma once
#include <span>
#include <string>
#include <vector>

#include "training/error_table.hpp"

namespace sandgraph::training {

// Errors of a model and of the one it started from on the same histories: means over the histories of each
// one's mean error (1 at most a step), the mean of their differences and its 95 % interval.
struct Comparison {
    std::string data;
    std::size_t histories = 0;
    double before = 0, after = 0, change = 0, interval = 0;  // shares of p

    bool better() const { return change < -interval; }
    bool worse() const { return change > interval; }
};

// Both measured at the same steps of the same histories, of which there is one at least. The interval of a
// single history is infinite.
Comparison compare(std::string data, std::span<const ErrorSample> before, std::span<const ErrorSample> after);

// Is the model better than `start`, on what was held out of its logs and, the guard against forgetting, on
// the shipped probes? One line of words, then the numbers. A guard without histories was not there.
std::string verdict(const Comparison& held_out, const Comparison& guard, const std::string& start);
// What is told and kept of it; without a start there is nothing to compare with.
struct Verdict {
    std::string start, words;
    std::vector<Comparison> comparisons;
};
std::string comparison_text(const Comparison& comparison);

}  // namespace sandgraph::training

#pragma once
#include <limits>
#include <string>

namespace sandgraph::scene {

// Allowed values of a key, in SI.
struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool low_excluded = false;

    bool contains(double value) const { return (low_excluded ? value > low : value >= low) && value <= high; }
    // "> 0 m", "0 to 1"; bounds written in `unit`. Empty for an unlimited range.
    std::string text(const std::string& unit) const;
};

inline Range above(double low) { return {.low = low, .low_excluded = true}; }
inline Range at_least(double low) { return {.low = low}; }
inline Range within(double low, double high) { return {.low = low, .high = high}; }
inline Range above_up_to(double low, double high) { return {low, high, true}; }

}  // namespace sandgraph::scene

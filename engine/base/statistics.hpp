#pragma once
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace sandgraph {

// What independent values of one thing tell. NaN: too few to tell.
struct Sample {
    std::size_t count = 0;
    double mean = std::numeric_limits<double>::quiet_NaN();
    double deviation = std::numeric_limits<double>::quiet_NaN();  // standard deviation, over count - 1
    double ci95 = std::numeric_limits<double>::quiet_NaN();       // half of the mean's interval, Student's t
};
Sample sample_of(std::span<const double> values);

// Linear between the values in order (the least is that of share 0, the largest that of 1); NaN of none.
double quantile(std::vector<double> values, double share);

}  // namespace sandgraph

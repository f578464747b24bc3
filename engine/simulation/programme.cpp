#include "simulation/programme.hpp"

#include <algorithm>

namespace sandgraph::simulation {

double settling_time(double width) {
    constexpr double a_metre = 0.05;  // [s/m]
    return a_metre * width;
}

double rate_at(const Programme& programme, double time) {  // docs/how_it_works.md (eq. 13)
    const double since = time - programme.settle;
    if (since <= 0) return 0;
    const double duration = 2 * programme.ramp / programme.rate;  // mean rate of a smoothstep is one half
    const double stop = duration + (programme.travel - programme.ramp) / programme.rate;
    if (programme.travel > 0 && since > stop) return 0;
    const double s = duration > 0 ? std::min(1.0, since / duration) : 1.0;
    return programme.rate * s * s * (3 - 2 * s);
}

}  // namespace sandgraph::simulation

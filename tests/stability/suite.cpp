#include "stability/suite.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>

#include "base/revision.hpp"

namespace sandgraph::stability {

void Findings::at_most(std::string what, double value, double high) {
    checks_.push_back({.what = std::move(what), .value = value, .high = high});
}
void Findings::at_least(std::string what, double value, double low) {
    checks_.push_back({.what = std::move(what), .value = value, .low = low});
}
void Findings::within(std::string what, double value, double low, double high) {
    checks_.push_back({std::move(what), value, low, high});
}
void Findings::exactly(std::string what, double value, double wanted) {
    within(std::move(what), value, wanted, wanted);
}
void Findings::note(std::string what, double value) { checks_.push_back({std::move(what), value}); }
void Findings::because(std::string why) { checks_.back().why = std::move(why); }

bool Outcome::holds() const {
    return std::ranges::all_of(found.checks(), [](const Check& c) { return c.holds(); });
}

Outcome run(const Case& c, Effort effort) {
    Outcome out{.name = c.name, .found = {}, .revision = sandgraph::revision()};
    const auto begin = std::chrono::steady_clock::now();
    try {
        c.run(effort, out.found);
    } catch (const std::exception& error) {
        out.found.at_least(std::string("ended: ") + error.what(), std::nan(""), 0);
    }
    out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return out;
}

}  // namespace sandgraph::stability

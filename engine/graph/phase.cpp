#include "graph/phase.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

namespace sandgraph::graph {
namespace {

std::map<std::string, std::size_t> writers(const std::vector<Phase>& phases) {
    std::map<std::string, std::size_t> out;
    for (std::size_t k = 0; k < phases.size(); ++k)
        for (const std::string& resource : phases[k].writes)
            if (!out.emplace(resource, k).second)
                throw std::logic_error("two phases of a step write " + resource + ": " +
                                       phases[out[resource]].name + " and " + phases[k].name);
    return out;
}

// Kahn's algorithm: every phase gets its turn unless some wait for each other.
void refuse_circle(const std::vector<Phase>& phases, const std::vector<std::vector<std::size_t>>& before) {
    std::vector<bool> done(phases.size(), false);
    for (std::size_t pass = 0; pass < phases.size(); ++pass)
        for (std::size_t k = 0; k < phases.size(); ++k)
            done[k] =
                done[k] || std::all_of(before[k].begin(), before[k].end(), [&](auto b) { return done[b]; });
    const auto stuck = std::find(done.begin(), done.end(), false);
    if (stuck != done.end())
        throw std::logic_error("the phases of a step wait for each other at " +
                               phases[static_cast<std::size_t>(stuck - done.begin())].name);
}

}  // namespace

std::vector<std::vector<std::size_t>> predecessors(const std::vector<Phase>& phases) {
    const auto writer = writers(phases);
    std::vector<std::vector<std::size_t>> before(phases.size());
    for (std::size_t k = 0; k < phases.size(); ++k) {
        for (const std::string& resource : phases[k].reads)
            if (const auto w = writer.find(resource); w != writer.end() && w->second != k)
                before[k].push_back(w->second);
        std::sort(before[k].begin(), before[k].end());
        before[k].erase(std::unique(before[k].begin(), before[k].end()), before[k].end());
    }
    refuse_circle(phases, before);
    return before;
}

}  // namespace sandgraph::graph

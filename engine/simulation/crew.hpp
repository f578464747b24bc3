#pragma once
#include <string>

#include "graph/rve_pool.hpp"

namespace sandgraph::simulation {

struct RunRequest;
struct RunOptions;

// Other processes that compute the same steps and hold a share of the packings (engine/ranks). This one
// writes the outputs. A run alone has no crew.
class Crew {
  public:
    virtual ~Crew() = default;
    virtual int size() const = 0;     // with this process
    virtual int threads() const = 0;  // of each, where nobody asks for a number
    // All that can be refused is checked: the others are to build the same simulation.
    virtual void begin(const RunRequest& request, const RunOptions& options,
                       const std::string& scene_hash) = 0;
    virtual graph::PoolMaker pool() = 0;
    // Before a step: whether packings may be looked at after it. Where they are not, nobody has to wait.
    virtual void announce(bool looked_at) = 0;
    virtual std::string account() const = 0;  // one line: what working together has cost
};

}  // namespace sandgraph::simulation

#pragma once
#include <span>
#include <vector>

#include "base/byte_stream.hpp"
#include "base/tensor.hpp"
#include "stress/screening_log.hpp"

namespace sandgraph::graph {

using stress::Switch;

// What the ground feels of a hand-over: the largest change of the stress that it is given in one step while
// the jump fades (Switch::felt), and in as many steps after that, when nothing fades any more
// (Switch::ordinary).
class FeltJumps {
  public:
    FeltJumps(std::size_t points, int fade_steps)
        : watch_of_(points, -1), before_(points), fade_(fade_steps) {}
    // The stress [Pa] that a step starts from; owned slots, so any thread may.
    void before(std::int32_t point, const Stress& stress) {
        if (watch_of_[static_cast<std::size_t>(point)] >= 0)
            before_[static_cast<std::size_t>(point)] = stress;
    }
    // The stresses that the step ends with, by point; changes are shares of max(p, floor).
    void after(std::span<const Stress> stress, double floor, std::vector<Switch>& switches);
    // The newest of `switches`; ends the watch of an older one of the same point.
    void watch(const std::vector<Switch>& switches);

    void save(ByteWriter& out) const { out.put(watches_); }
    void load(ByteReader& in, std::size_t switches);  // how many there are

  private:
    struct Watch {
        std::int32_t point = 0, of = 0;  // index among the switches
        std::int64_t steps = 0;
    };
    void forget_ended();

    std::vector<Watch> watches_;
    std::vector<std::int32_t> watch_of_;  // by point: in watches_, or -1
    std::vector<Stress> before_;          // by point
    int fade_;
};

}  // namespace sandgraph::graph

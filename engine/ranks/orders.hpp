#pragma once
#include <cstdint>
#include <exception>

#include "ranks/team.hpp"

namespace sandgraph::ranks {

// What rank 0 tells the others, who wait for it between their steps.
struct Order {
    enum class Kind : std::uint64_t {
        begin,  // a run: its description follows
        go,     // into the next step's packings
        show,   // the packings [first, last) as they are now
        stop,   // there is nothing more to do
    };
    Kind kind = Kind::stop;
    std::uint64_t first = 0, last = 0;  // of `begin`: 0 and the length of what follows [B]
};

// By rank 0, to all others.
void tell(Team& team, const Order& order);
// By all others.
Order hear(Team& team);

// Leaves a step that rank 0 does not take any more.
struct Dismissed : std::exception {
    const char* what() const noexcept override { return "dismissed by rank 0"; }
};

}  // namespace sandgraph::ranks

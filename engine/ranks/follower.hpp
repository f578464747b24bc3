#pragma once
#include "ranks/team.hpp"

namespace sandgraph::ranks {

// The life of a rank beside rank 0: waits for a run, computes its steps without a word or a file, and comes
// back when rank 0 says stop. What fails here alone ends all ranks with a line that says where and why.
void follow(Team& team);

}  // namespace sandgraph::ranks

#pragma once
#include <string>

namespace sandgraph::training {

struct TrainCommand {
    std::string recipe, out;
    std::string probes;    // a log beside those of the recipe; "": none
    bool ladder = false;   // train and measure every rung, write the recipe's
    bool measure = false;  // train and measure, write no model: also for laws that cannot be served
    std::string evaluate;  // a model to measure on the held-out histories instead of training one; "": none
};

// Writes OUT, OUT's card and error table; answers the exit code: 0, or 3 when stopped and resumable.
int run(const TrainCommand& command);

}  // namespace sandgraph::training

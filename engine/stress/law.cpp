#include "stress/law.hpp"

#include <array>

namespace sandgraph::stress {

const char* name_of(Data data) {
    static constexpr std::array<const char*, data_count> names = {
        "points", "increments", "stress",  "order",    "grid", "bodies", "contact",
        "visits", "due",        "answers", "packings", "law",  "energy"};
    return names[static_cast<std::size_t>(data)];
}

std::vector<Stage> Law::stages() {
    return {{"law",
             {{Data::increments, 1}, {Data::stress, 0}, {Data::law, 0}},
             {{Data::stress, 1}, {Data::law, 1}},
             [this](const Batch& batch) { update(batch); }}};
}

}  // namespace sandgraph::stress

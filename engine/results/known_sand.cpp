#include "results/known_sand.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <numeric>

#include "base/contracts.hpp"
#include "graph/settings.hpp"

namespace sandgraph::results {

KnownSand known_sand(const packings::PreparedGround& ground) {
    SG_EXPECT(ground.surrogate && !ground.traits.empty());
    const stress::Surrogate& law = *ground.surrogate;
    const std::size_t rows = ground.traits.size(), size = law.state_size();
    std::vector<double> states(rows * size);
    std::vector<std::int32_t> points(rows);
    std::iota(points.begin(), points.end(), 0);
    for (std::size_t row = 0; row < rows; ++row) {
        const double p = ground.traits[row].pressure;
        law.start(ground.traits[row], {-p, -p, 0}, std::span(states).subspan(row * size, size));
    }
    // An increment that does nothing: the surrogate looks where it stands.
    const std::vector<Mat2> still(rows, Mat2::Identity());
    std::vector<stress::SurrogateAnswer> answers(rows);
    law.update(points, still, states, answers);
    KnownSand sand;
    for (const stress::SurrogateAnswer& answer : answers)
        sand.distance = std::max(sand.distance, answer.distance);
    sand.known = sand.distance <= graph::GateSettings{}.distance;
    return sand;
}

std::string unknown_sand_text(const KnownSand& sand, const packings::PreparedGround& ground) {
    if (sand.known) return "";
    return fmt::format(
        "the surrogate has not seen such sand: peak friction {:.1f} deg, porosity {:.3f}, up to {:.1f} "
        "widths outside "
        "its trained range; the gate is off, so the load may be off by tens of per cent: run with "
        "gate.active = true, "
        "or in full",
        ground.friction_angle * 180 / std::numbers::pi, ground.traits[ground.traits.size() / 2].porosity,
        sand.distance);
}

}  // namespace sandgraph::results

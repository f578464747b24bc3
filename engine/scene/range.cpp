#include "scene/range.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/units.hpp"

namespace sandgraph::scene {

std::string Range::text(const std::string& unit) const {
    const std::string least = std::isinf(low) ? "" : format_quantity(low, unit);
    const std::string most = std::isinf(high) ? "" : format_quantity(high, unit);
    const std::string lower = least.empty() ? "" : fmt::format("{} {}", low_excluded ? ">" : ">=", least);
    if (most.empty()) return lower;
    if (least.empty()) return "<= " + most;
    return low_excluded ? fmt::format("{} and <= {}", lower, most) : fmt::format("{} to {}", least, most);
}

}  // namespace sandgraph::scene

#include "report/colour_scale.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace sandgraph::report {
namespace {

constexpr double tail = 0.0015;  // share of the points beyond each end

double quantile(const std::vector<double>& sorted, double share) {
    return sorted[static_cast<std::size_t>(std::lround(share * static_cast<double>(sorted.size() - 1)))];
}

}  // namespace

ColourRange colour_range(std::vector<double> values, ValueKind kind, double least) {
    std::erase_if(values, [](double v) { return !std::isfinite(v); });
    if (values.empty()) values = {0};
    std::sort(values.begin(), values.end());
    double low = quantile(values, tail), high = quantile(values, 1 - tail);
    if (kind == ValueKind::signed_value) {
        high = std::max({std::abs(low), std::abs(high), least}), low = -high;
    } else {
        if (kind == ValueKind::magnitude) low = std::min(0.0, low);
        high = std::max(high, low + least);
    }
    const double step = round_step(high - low, 10);
    return {step * std::floor(low / step + 1e-9), step * std::ceil(high / step - 1e-9)};
}

ColourRange joined(const ColourRange& a, const ColourRange& b) {
    return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

std::string beyond(const ColourRange& range, const std::vector<double>& values) {
    const double slack = 1e-9 * (range.high - range.low);
    const bool some = std::ranges::any_of(
        values, [&](double v) { return v < range.low - slack || v > range.high + slack; });
    return some ? ", scale exceeded" : "";
}

double round_step(double width, double parts) {
    const double power = std::pow(10.0, std::floor(std::log10(width / parts))), lead = width / parts / power;
    return power * (lead < 2 ? 1 : lead < 5 ? 2 : 5);
}

std::string palette(ValueKind kind) {
    if (kind == ValueKind::signed_value)
        return "set palette defined (0 '#3b4cc0', 1 '#6788ee', 2 '#9abbff', 3 '#c9d7f0', 4 '#f0f0f0', "
               "5 '#edd1c2', 6 '#f7a889', 7 '#e26952', 8 '#b40426')\n";
    if (kind == ValueKind::magnitude)
        return "set palette defined (0 '#f3f3ee', 1 '#fbe8b0', 2 '#fec98d', 3 '#fd9a6a', 4 '#f4675c', "
               "5 '#d8456c', 6 '#ab337c', 7 '#7b2382')\n";
    return "set palette defined (0 '#440154', 1 '#472c7a', 2 '#3b518b', 3 '#2c718e', 4 '#21908d', "
           "5 '#27ad81', 6 '#5cc863', 7 '#aadc32', 8 '#fde725')\n";
}

const char* kind_colour(std::size_t k) {
    constexpr std::array colours = {"#440154", "#3b518b", "#2c8f8e", "#8fbf6a", "#fde725", "#e26952"};
    return colours[k % colours.size()];
}

}  // namespace sandgraph::report

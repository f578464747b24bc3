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

ColourRange colour_range(std::vector<double> values, bool is_signed, bool from_zero) {
    std::erase_if(values, [](double v) { return !std::isfinite(v); });
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    double low = quantile(values, tail), high = quantile(values, 1 - tail);
    if (is_signed) high = std::max(std::abs(low), std::abs(high)), low = -high;
    if (from_zero && !is_signed) low = std::min(0.0, low);
    if (!(high - low > 1e-12 * std::max(1.0, std::abs(high)))) high = low + 1e-3;
    const double step = round_step(high - low, 10);
    ColourRange range{step * std::floor(low / step + 1e-9), step * std::ceil(high / step - 1e-9)};
    range.clipped_low = values.front() < range.low - 1e-9 * step;
    range.clipped_high = values.back() > range.high + 1e-9 * step;
    return range;
}

double round_step(double width, double parts) {
    const double power = std::pow(10.0, std::floor(std::log10(width / parts))), lead = width / parts / power;
    return power * (lead < 2 ? 1 : lead < 5 ? 2 : 5);
}

std::string palette(bool is_signed) {
    if (is_signed)
        return "set palette defined (0 '#3b4cc0', 1 '#6788ee', 2 '#9abbff', 3 '#c9d7f0', 4 '#dddddd', "
               "5 '#edd1c2', 6 '#f7a889', 7 '#e26952', 8 '#b40426')\n";
    return "set palette defined (0 '#440154', 1 '#472c7a', 2 '#3b518b', 3 '#2c718e', 4 '#21908d', "
           "5 '#27ad81', 6 '#5cc863', 7 '#aadc32', 8 '#fde725')\n";
}

const char* kind_colour(std::size_t k) {
    constexpr std::array colours = {"#440154", "#3b518b", "#2c8f8e", "#8fbf6a", "#fde725", "#e26952"};
    return colours[k % colours.size()];
}

}  // namespace sandgraph::report

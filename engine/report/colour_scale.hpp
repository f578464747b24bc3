#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace sandgraph::report {

// The range of colours. The outermost 0.15 % of the points may lie beyond it: one runaway point must not
// bleach the picture.
struct ColourRange {
    double low = 0, high = 1;
    bool clipped_low = false, clipped_high = false;
};

// Signed values: symmetric about zero. Others: from zero if `from_zero`, else from their own lower end; ends
// on round numbers. NaNs are left out.
ColourRange colour_range(std::vector<double> values, bool is_signed, bool from_zero);

// 1, 2 or 5 times a power of ten that divides a width > 0 into about `parts`.
double round_step(double width, double parts);

// gnuplot commands: viridis (perceptually uniform) or, for signed values, cool-warm (Moreland 2009).
std::string palette(bool is_signed);

// Of the k-th kind of a list, told apart by lightness and hue; repeats after the sixth.
const char* kind_colour(std::size_t k);

// Okabe & Ito (2008): distinguishable with colour-vision deficiency.
inline constexpr std::array<const char*, 7> series_colours{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                           "#E69F00", "#56B4E9", "#000000"};

inline const char* series_colour(std::size_t k) { return series_colours[k % series_colours.size()]; }

}  // namespace sandgraph::report

#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace sandgraph::report {

// What the values of a field are. Magnitudes start from zero, which is pale: where nothing has moved nothing
// is painted. Signed ones lie about a pale zero. Levels start anywhere.
enum class ValueKind { magnitude, signed_value, level };

// The range of colours. The outermost 0.15 % of the points may lie beyond it: one runaway point must not
// bleach the picture.
struct ColourRange {
    double low = 0, high = 1;
    bool operator==(const ColourRange&) const = default;
};

// Magnitudes: from zero. Signed values: symmetric about zero. Levels: from their own lower end. Ends on round
// numbers, at least `least` > 0 apart (a signed one: from zero), so that noise at rest is no pattern. NaNs
// are left out.
ColourRange colour_range(std::vector<double> values, ValueKind kind, double least);

// One for several frames of a field.
ColourRange joined(const ColourRange& a, const ColourRange& b);

// ", scale exceeded" where values lie beyond the range; else empty.
std::string beyond(const ColourRange& range, const std::vector<double>& values);

// 1, 2 or 5 times a power of ten that divides a width > 0 into about `parts`.
double round_step(double width, double parts);

// gnuplot commands. Magnitudes: magma backwards, from pale to purple, without its darkest end, on which a
// black plate would be lost. Signed values: cool-warm (Moreland 2009). Levels: viridis. All are even in
// perceived lightness.
std::string palette(ValueKind kind);

// Of the k-th kind of a list, told apart by lightness and hue; repeats after the sixth.
const char* kind_colour(std::size_t k);

// Okabe & Ito (2008): distinguishable with colour-vision deficiency.
inline constexpr std::array<const char*, 7> series_colours{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                           "#E69F00", "#56B4E9", "#000000"};

inline const char* series_colour(std::size_t k) { return series_colours[k % series_colours.size()]; }

}  // namespace sandgraph::report

#pragma once
#include <array>
#include <cstddef>

namespace sandgraph::report {

// Okabe & Ito (2008): distinguishable with colour-vision deficiency.
inline constexpr std::array<const char*, 7> series_colours{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                           "#E69F00", "#56B4E9", "#000000"};

inline const char* series_colour(std::size_t k) { return series_colours[k % series_colours.size()]; }

}  // namespace sandgraph::report

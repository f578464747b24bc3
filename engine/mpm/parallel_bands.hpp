#pragma once
#include <oneapi/tbb/parallel_for.h>

#include <span>

#include "base/contracts.hpp"
#include "mpm/order.hpp"

namespace sandgraph::mpm {

// Below this many points the work of a step is shorter than waking a thread.
inline constexpr std::size_t serial_limit = 1500;

inline std::span<const std::int32_t> band(const Order& order, std::size_t b) {
    SG_EXPECT(b < order.bands());
    const auto from = static_cast<std::size_t>(order.first[b]),
               to = static_cast<std::size_t>(order.first[b + 1]);
    return std::span(order.ids).subspan(from, to - from);
}

// f(ids of the band) for bands first, first + step, ...; at once if the order is long enough.
template <class F>
void for_bands(const Order& order, std::size_t first, std::size_t step, F f) {
    SG_EXPECT(step > 0);
    const auto run = [&](std::size_t b) {
        if (const auto ids = band(order, b); !ids.empty()) f(ids);
    };
    if (order.ids.size() < serial_limit)
        for (std::size_t b = first; b < order.bands(); b += step) run(b);
    else
        oneapi::tbb::parallel_for(first, order.bands(), step, run, oneapi::tbb::simple_partitioner{});
}

// f(id) for all points; those of bands at once.
template <class F>
void for_points(const Order& order, F f) {
    for_bands(order, 0, 1, [&](std::span<const std::int32_t> ids) {
        for (const auto id : ids) f(static_cast<std::size_t>(id));
    });
    for (const auto id : order.near) f(static_cast<std::size_t>(id));
}

}  // namespace sandgraph::mpm

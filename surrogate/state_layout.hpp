#pragma once
#include <span>

#include "surrogate/element_update.hpp"

namespace sandgraph::surrogate {

// A point's state as doubles: J, fabric (2), constants (6), then per member p, gamma, strength scale, re t_k
// [M], im t_k [M]; each group filled up with zeros to a multiple of four, as the kernel loads four at a time.
struct StateLayout {
    std::size_t elements = 0, members = 0;

    static constexpr std::size_t volume = 0, fabric = 1, constants = 3, shared = 12;
    constexpr std::size_t member_size() const { return (3 + 2 * elements + 3) / 4 * 4; }
    constexpr std::size_t member(std::size_t m) const { return shared + m * member_size(); }
    constexpr std::size_t size() const { return member(members); }
};

inline constexpr std::size_t max_state = StateLayout{max_elements, max_members}.size();

// The same, named.
struct PointState {
    double volume = 1;  // J since the start
    Deviator fabric;    // of the contacts at the start, turned with the point
    PointConstants constants;
    std::vector<MemberState> members;
};

PointState unpack(const StateLayout& layout, std::span<const double> state);
void pack(const StateLayout& layout, const PointState& point, std::span<double> state);

}  // namespace sandgraph::surrogate

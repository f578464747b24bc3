#pragma once
#include <algorithm>
#include <vector>

#include "dem/fast/state.hpp"

namespace sandgraph::dem {

// The pair list seen from the grains, for the formulations without a scatter. Grains of equally many contacts
// stand together, so that loops have no unforeseeable ends.
struct GrainContacts {
    struct Class {
        int grains, contacts;
    };
    std::vector<Class> classes;
    std::vector<std::uint16_t> order, entries;  // entries: 2 slot + (1 for the first grain of the pair)
    Aligned<double> pair_force;                 // [4 slots]

    // Eight grains side by side, filled up with the padding grain.
    std::vector<std::uint16_t> lanes_order, partner;
    std::vector<std::uint8_t> partner_image;
    std::vector<int> lanes_contacts;
    Aligned<double> tangential, moment;

    explicit GrainContacts(const FastState& s);

  private:
    void fill_lanes(const FastState& s, const std::vector<std::vector<int>>& of);
};

inline GrainContacts::GrainContacts(const FastState& s) : pair_force(4 * std::size_t(s.slots)) {
    std::vector<std::vector<int>> of(s.grains + 1);
    for (int c = 0; c < s.slots; ++c) of[s.j[c]].push_back(2 * c), of[s.i[c]].push_back(2 * c + 1);
    of.pop_back();
    for (int g = 0; g < s.grains; ++g) order.push_back(static_cast<std::uint16_t>(g));
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return of[a].size() > of[b].size(); });
    for (const int g : order) {
        const int contacts = static_cast<int>(of[g].size());
        if (classes.empty() || classes.back().contacts != contacts) classes.push_back({0, contacts});
        ++classes.back().grains;
        entries.insert(entries.end(), of[g].begin(), of[g].end());
    }
    fill_lanes(s, of);
}

inline void GrainContacts::fill_lanes(const FastState& s, const std::vector<std::vector<int>>& of) {
    lanes_order = order;
    while (lanes_order.size() % 8) lanes_order.push_back(static_cast<std::uint16_t>(s.grains));
    for (std::size_t first = 0; first < lanes_order.size(); first += 8) {
        lanes_contacts.push_back(static_cast<int>(of[lanes_order[first]].size()));
        for (int k = 0; k < lanes_contacts.back(); ++k)
            for (int l = 0; l < 8; ++l) {
                const int g = lanes_order[first + l];
                const bool real = g < s.grains && k < static_cast<int>(of[g].size());
                const int slot = real ? of[g][k] / 2 : 0, is_first = real ? of[g][k] % 2 : 0;
                partner.push_back(real ? (is_first ? s.j[slot] : s.i[slot]) : std::uint16_t(s.grains));
                partner_image.push_back(real ? (is_first ? s.image[slot] : 8 - s.image[slot]) : 8);
                tangential.push_back(real ? s.tangential[slot] : 0);
                moment.push_back(real ? (is_first ? 1 : -1) * s.moment[slot] : 0);
            }
    }
}

}  // namespace sandgraph::dem

#include "dem/mixed/packing.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace sandgraph::dem {
namespace {

template <class Values>
void put(ByteWriter& out, const Values& values) {
    out.put(std::span<const typename Values::value_type>(values));
}
void put(ByteWriter& out, const Mat2& m) { out.put(std::span<const double>(m.data(), 4)); }

template <class Values>
void take(ByteReader& in, Values& values, std::size_t size) {
    values.resize(size);
    in.take(std::span<typename Values::value_type>(values));
}
void take(ByteReader& in, Mat2& m) { in.take(std::span<double>(m.data(), 4)); }

void require_sound(const MixedPacking& p, double radius_max) {
    require_state(p.pairs >= 0 && static_cast<std::size_t>(p.pairs) <= p.partner.size(), "pairs");
    for (const auto* places : {&p.partner, &p.loose_first})
        require_state(std::ranges::all_of(*places, [&](std::size_t place) { return place < p.room(); }),
                      "pairs");
    require_state(std::ranges::all_of(p.loose_gap, [](float gap) { return gap >= -1; }), "numbers");
    require_state(p.H.allFinite() && p.L.allFinite() && std::isfinite(p.wear), "numbers");
    require_state(!too_thin(p.H, radius_max), "cells");
    for (const auto* values :
         {&p.x_rest, &p.y_rest, &p.u, &p.v, &p.w, &p.inverse_allowance2, &p.tangential, &p.moment})
        require_state(std::ranges::all_of(*values, [](float x) { return std::isfinite(x); }), "numbers");
}

}  // namespace

void save(const MixedPacking& p, ByteWriter& out) {
    put(out, p.H), put(out, p.L);
    out.put(p.wear), out.put(p.pairs);
    put(out, p.x), put(out, p.y), put(out, p.inverse_allowance2);
    put(out, p.x_rest), put(out, p.y_rest);
    put(out, p.u), put(out, p.v), put(out, p.w);
    put(out, p.rows), out.put(p.loose_gap);
    put(out, p.partner), put(out, p.loose_first);
    put(out, p.tangential), put(out, p.moment);
}

void load(MixedPacking& p, int grains, double radius_max, ByteReader& in) {
    take(in, p.H), take(in, p.L);
    in.take(p.wear), in.take(p.pairs);
    const std::size_t room = room_for(grains);
    p.grains = grains;
    take(in, p.x, room), take(in, p.y, room);
    take(in, p.inverse_allowance2, room);
    take(in, p.x_rest, room), take(in, p.y_rest, room);
    take(in, p.u, room), take(in, p.v, room), take(in, p.w, room);
    take(in, p.rows, room / MixedPacking::kLanes);
    in.take(p.loose_gap);
    constexpr std::size_t kLanes = MixedPacking::kLanes;
    const std::size_t loose = kLanes * p.loose_gap.size();
    const std::size_t slots = std::accumulate(p.rows.begin(), p.rows.end(), loose,
                                              [](std::size_t sum, int rows) { return sum + kLanes * rows; });
    take(in, p.partner, slots), take(in, p.loose_first, loose);
    take(in, p.tangential, slots), take(in, p.moment, slots);
    require_sound(p, radius_max);
}

}  // namespace sandgraph::dem

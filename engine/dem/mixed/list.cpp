#include "dem/mixed/list.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/contracts.hpp"
#include "dem/fast/neighbour_list.hpp"
#include "dem/mixed/packing.hpp"

namespace sandgraph::dem {
namespace {

constexpr int kRecord = 8, kRadius = 4;  // of the search

// Integer coordinates follow the change of basis to the bit, modulo the period.
void reduce(MixedPacking& p, const Reduction& r) {
    p.H *= r.U.cast<double>();
    for (std::size_t g = 0; g < p.room(); ++g) {
        const auto x = static_cast<std::uint32_t>(p.x[g]), y = static_cast<std::uint32_t>(p.y[g]);
        const auto row = [&](int k) {
            return static_cast<std::int32_t>(static_cast<std::uint32_t>(r.U_inverse(k, 0)) * x +
                                             static_cast<std::uint32_t>(r.U_inverse(k, 1)) * y);
        };
        p.x[g] = row(0), p.y[g] = row(1);
    }
}

}  // namespace

double mixed_gap(double radius_max) {
    constexpr double share = 0.5;
    return share * listed_gap(radius_max);
}

double least_height(double radius_max) { return 2 * (2 * radius_max + mixed_gap(radius_max)); }

NearestImage nearest_image(const MixedPacking& p, int i, int j) {
    const auto image = [](std::int32_t from, std::int32_t to, std::int32_t& branch) {
        const auto a = static_cast<std::uint32_t>(from), b = static_cast<std::uint32_t>(to);
        branch = static_cast<std::int32_t>(b - a);
        return static_cast<std::int16_t>((std::int64_t{branch} - (std::int64_t{b} - std::int64_t{a})) >> 32);
    };
    NearestImage out{};
    out.cell_x = image(p.x[i], p.x[j], out.x), out.cell_y = image(p.y[i], p.y[j], out.y);
    return out;
}

void contact_history(const MixedPacking& p, std::vector<Contact>& out) {
    out.clear();
    for_each_pair(p, [&](std::size_t slot, int i, int j) {
        if (p.tangential[slot] == 0 && p.moment[slot] == 0) return;
        const NearestImage image = nearest_image(p, i, j);
        out.push_back({i, j, image.cell_x, image.cell_y, p.tangential[slot], p.moment[slot]});
    });
}

void MixedList::rebuild(MixedState& state) {
    contact_history(state.packing, history_);
    relist(state, history_);
}

void MixedList::relist(MixedState& s, const std::vector<Contact>& history) {
    MixedPacking& p = s.packing;
    SG_EXPECT(p.grains > 0 && p.H.determinant() != 0);
    if (const Reduction r = reduce_cell(p.H); !r.identity) reduce(p, r);
    list_pairs(s);
    collect(p.grains, history);
    deal(p, owners_.share(pairs_, touching_, p.grains));
    s.stiffness.resize(p.partner.size()), s.stiffness_known = false;
    p.approach = 0;
    SG_ENSURE(all_below(p.partner, static_cast<int>(p.room())) && !stale(s));
}

void MixedList::list_pairs(const MixedState& s) {
    const MixedPacking& p = s.packing;
    centres_.resize(std::size_t{kRecord} * p.grains);
    for (int g = 0; g < p.grains; ++g) {
        const Vec2 x = centre(p, g);
        double* record = &centres_[std::size_t{kRecord} * g];
        record[0] = x.x(), record[1] = x.y(), record[kRadius] = s.radius[g];
    }
    pairs_ = search_.find(centres_.data(), p.grains, p.H, mixed_gap(s.radius_max));
    sort_touching_first(s);
}

// Pairs that touch, or soon will, first: rows of the others cost the pair loop little.
void MixedList::sort_touching_first(const MixedState& s) {
    constexpr double kSoon = 0.05;
    const double soon = kSoon * mixed_gap(s.radius_max);
    loose_.clear();
    touching_ = 0;
    for (const NearPair& pair : pairs_) {
        const double *a = &centres_[std::size_t{kRecord} * pair.i], *b = &centres_[std::size_t{kRecord} * pair.j];
        const Vec2 d = Vec2(b[0] - a[0], b[1] - a[1]) + s.packing.H * Vec2(pair.cell_x, pair.cell_y);
        if (d.norm() < a[kRadius] + b[kRadius] + soon)
            pairs_[touching_++] = pair;
        else
            loose_.push_back(pair);
    }
    std::copy(loose_.begin(), loose_.end(), pairs_.begin() + touching_);
}

// Orders the history by first grain, i < j. Images do not matter: that of a pair is the nearest.
void MixedList::collect(int grains, const std::vector<Contact>& history) {
    first_.assign(grains + 1, 0);
    old_.resize(history.size());
    for (const Contact& c : history) ++first_[std::min(c.i, c.j)];
    int sum = 0;
    for (int& start : first_) sum += start, start = sum;
    for (std::size_t k = history.size(); k-- > 0;) {
        Contact c = history[k];
        if (c.i > c.j) std::swap(c.i, c.j), c.moment = -c.moment;
        old_[--first_[c.i]] = c;
    }
}

const Contact* MixedList::find(const NearPair& p) const {
    for (int k = first_[p.i]; k < first_[p.i + 1]; ++k)
        if (old_[k].j == p.j) return &old_[k];
    return nullptr;
}

// A lane for each grain, as many rows as the busiest grain of the block has pairs.
void MixedList::deal(MixedPacking& p, const std::vector<std::int32_t>& owner) {
    constexpr int kLanes = MixedPacking::kLanes;
    p.pairs = static_cast<int>(pairs_.size());
    used_.assign(p.room(), 0);
    for (const std::int32_t g : owner) ++used_[g];
    p.rows.resize(p.room() / kLanes);
    std::size_t slots = 0;
    for (std::size_t block = 0; block < p.rows.size(); ++block) {
        const auto of_block = used_.begin() + static_cast<std::ptrdiff_t>(kLanes * block);
        p.rows[block] = static_cast<std::uint8_t>(*std::max_element(of_block, of_block + kLanes));
        for (int l = 0; l < kLanes; ++l) of_block[l] = static_cast<int>(slots) + l;
        slots += std::size_t{kLanes} * p.rows[block];
    }
    p.partner.assign(slots, static_cast<std::uint16_t>(place_of(p.grains)));
    p.tangential.assign(slots, 0), p.moment.assign(slots, 0);
    for (int k = 0; k < p.pairs; ++k) {
        fill(p, static_cast<std::size_t>(used_[owner[k]]), k, owner[k] == pairs_[k].i);
        used_[owner[k]] += kLanes;
    }
}

void MixedList::fill(MixedPacking& p, std::size_t slot, int k, bool first_owns) const {
    const NearPair& pair = pairs_[k];
    p.partner[slot] = static_cast<std::uint16_t>(place_of(first_owns ? pair.j : pair.i));
    const Contact* c = find(pair);
    if (!c) return;
    p.tangential[slot] = static_cast<float>(c->tangential);
    p.moment[slot] = static_cast<float>(first_owns ? c->moment : -c->moment);
}

double MixedList::approach(const MixedState& s, double speed2, double dt) const {
    SG_EXPECT(!(speed2 < 0) && dt >= 0);  // not a number when the packing diverges
    const double reach = 2 * s.radius_max + mixed_gap(s.radius_max);
    return dt * (2 * std::sqrt(speed2) + s.packing.L.norm() * reach);
}

}  // namespace sandgraph::dem

#include "dem/mixed/list.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/contracts.hpp"
#include "dem/fast/neighbour_list.hpp"
#include "dem/mixed/geometry.hpp"
#include "dem/mixed/kernel.hpp"

namespace sandgraph::dem {
namespace {

constexpr int kRecord = 8, kRadius = 4;  // of the search
constexpr int kClasses = 64;             // of gaps

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
        const Vec2 rest = r.U_inverse.cast<double>() * Vec2(p.x_rest[g], p.y_rest[g]);
        p.x_rest[g] = float(rest.x()), p.y_rest[g] = float(rest.y());
    }
}

std::uint16_t padding_place(const MixedPacking& p) { return static_cast<std::uint16_t>(place_of(p.grains)); }

}  // namespace

double allowance(double radius_max) { return 0.75 * listed_gap(radius_max); }

double least_height(double radius_max) { return 2 * (2 * radius_max + 2.0 * kFast * allowance(radius_max)); }

void contact_history(const MixedPacking& p, std::vector<Contact>& out) {
    out.clear();
    for_each_pair(p, [&](std::size_t slot, int i, int j) {
        if (p.tangential[slot] == 0 && p.moment[slot] == 0) return;
        const double moment = i < j ? p.moment[slot] : -p.moment[slot];
        if (i > j) std::swap(i, j);
        const NearestImage image = nearest_image(p, i, j);
        out.push_back({i, j, image.cell_x, image.cell_y, p.tangential[slot], moment});
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
    allow(s);
    find_pairs(s);
    sort_by_gap(p);
    collect(p.grains, history);
    const int dealt = dealt_pairs(p.grains);
    deal(p, owners_.share(pairs_, dealt, p.grains));
    follow_loose(p, dealt);
    s.stiffness.resize(p.partner.size()), s.stiffness_known = false;
    p.wear = 0;
    SG_ENSURE(all_below(p.partner, static_cast<int>(p.room())));
    SG_ENSURE(all_below(p.loose_first, static_cast<int>(p.room())));
}

// By the grain's speed over the mean one: a list is worn by the fastest few.
void MixedList::allow(MixedState& s) {
    MixedPacking& p = s.packing;
    const auto speed = [&](int g) { return std::sqrt(p.u[g] * p.u[g] + p.v[g] * p.v[g]); };
    float sum = 0;
    for (int g = 0; g < p.grains; ++g) sum += speed(g);
    const float quiet = std::max(2 * sum / static_cast<float>(p.grains), 1e-30f),
                least = static_cast<float>(allowance(s.radius_max));
    allowed_.assign(p.room(), 0), reach_.assign(p.room(), 0);
    for (int g = 0; g < p.grains; ++g) {
        allowed_[g] = least * std::clamp(speed(g) / quiet, 1.0f, kFast);
        reach_[g] = s.radius[g] + allowed_[g];
        p.inverse_allowance2[g] = 1 / (allowed_[g] * allowed_[g]);
    }
}

void MixedList::find_pairs(const MixedState& s) {
    constexpr int kFew = 1500;
    if (s.packing.grains > kFew) return find_by_bins(s);
    near_pairs(s.packing, reach_, found_);
}

void MixedList::find_by_bins(const MixedState& s) {
    const MixedPacking& p = s.packing;
    centres_.resize(std::size_t{kRecord} * p.grains);
    for (int g = 0; g < p.grains; ++g) {
        const Vec2 x = centre(p, g);
        double* record = &centres_[std::size_t{kRecord} * g];
        record[0] = x.x(), record[1] = x.y(), record[kRadius] = reach_[g];
    }
    found_ = search_.find(centres_.data(), p.grains, p.H, 0);
}

// The gap of a pair as a share of what both grains are allowed.
double MixedList::share_of_allowance(const MixedPacking& p, const NearPair& pair) const {
    const Mat2 cell = p.H / 4294967296.0;
    const auto less = [](std::int32_t a, std::int32_t b) {
        return double(static_cast<std::int32_t>(std::uint32_t(a) - std::uint32_t(b)));
    };
    const double a = less(p.x[pair.j], p.x[pair.i]), b = less(p.y[pair.j], p.y[pair.i]);
    const double dx = cell(0, 0) * a + cell(0, 1) * b, dy = cell(1, 0) * a + cell(1, 1) * b;
    const double apart = std::sqrt(dx * dx + dy * dy);
    const double allowed = double(allowed_[pair.i]) + double(allowed_[pair.j]);
    return (apart - reach_[pair.i] - reach_[pair.j] + allowed) / allowed;
}

// Class 0 touches, the others divide the allowance evenly. A counting sort.
void MixedList::sort_by_gap(const MixedPacking& p) {
    class_end_.assign(kClasses + 1, 0), class_of_.clear();
    for (const NearPair& pair : found_) {
        const double share = kClasses * share_of_allowance(p, pair);
        class_of_.push_back(share < 0 ? 0 : std::min(kClasses, 1 + static_cast<int>(share)));
        ++class_end_[class_of_.back()];
    }
    int sum = 0;
    for (int& end : class_end_) sum += end, end = sum;
    pairs_.resize(found_.size());
    for (std::size_t k = found_.size(); k-- > 0;) pairs_[--class_end_[class_of_[k]]] = found_[k];
    std::rotate(class_end_.begin(), class_end_.begin() + 1, class_end_.end());
    class_end_.back() = sum;
}

// The nearest, as many as fill whole rows: a row too few leaves pairs that touch to the loose rows, a row too
// many is mostly empty.
int MixedList::dealt_pairs(int grains) const {
    constexpr double kFull = 0.95;  // more is seldom dealt out evenly
    const double a_row = kFull * grains;
    const auto rows = std::max(1.0, std::round(class_end_[0] / a_row));
    return std::min(static_cast<int>(rows * a_row), static_cast<int>(pairs_.size()));
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

// As many rows as the busiest grain of a block has pairs.
void MixedList::lay_rows(MixedPacking& p, const std::vector<std::int32_t>& owner) {
    constexpr std::size_t kLanes = MixedPacking::kLanes;
    slot_.assign(p.room(), 0);
    for (const std::int32_t g : owner) ++slot_[g];
    p.rows.resize(p.room() / kLanes);
    std::size_t slots = 0;
    for (std::size_t block = 0; block < p.rows.size(); ++block) {
        const auto of_block = slot_.begin() + static_cast<std::ptrdiff_t>(kLanes * block);
        const std::size_t rows = *std::max_element(of_block, of_block + kLanes);
        for (std::size_t l = 0; l < kLanes; ++l) of_block[l] = slots + l;
        p.rows[block] = static_cast<std::uint8_t>(rows), slots += kLanes * rows;
    }
    const std::size_t loose = (pairs_.size() - owner.size() + kLanes - 1) / kLanes;
    p.loose_gap.assign(loose, 0), p.loose_first.assign(kLanes * loose, padding_place(p));
    p.partner.assign(slots + kLanes * loose, padding_place(p));
    p.tangential.assign(p.partner.size(), 0), p.moment.assign(p.partner.size(), 0);
}

void MixedList::deal(MixedPacking& p, const std::vector<std::int32_t>& owner) {
    p.pairs = static_cast<int>(pairs_.size());
    lay_rows(p, owner);
    for (std::size_t k = 0; k < owner.size(); ++k) {
        fill(p, slot_[owner[k]], static_cast<int>(k), owner[k] == pairs_[k].i);
        slot_[owner[k]] += MixedPacking::kLanes;
    }
}

// Row by row as they are sorted; a row's gap is where the class of its first pair begins.
void MixedList::follow_loose(MixedPacking& p, int dealt) {
    const std::size_t begin = p.partner.size() - p.loose_first.size();
    int gap_class = 0;
    for (int k = dealt; k < p.pairs; ++k) {
        const auto at = static_cast<std::size_t>(k - dealt);
        fill(p, begin + at, k, true);
        p.loose_first[at] = static_cast<std::uint16_t>(place_of(pairs_[k].i));
        while (class_end_[gap_class] <= k) ++gap_class;
        if (at % MixedPacking::kLanes == 0)
            p.loose_gap[at / MixedPacking::kLanes] = 0.999f * static_cast<float>(gap_class - 1) / kClasses;
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

bool MixedList::moved(MixedState& s, double rate2, double dt) const {
    SG_EXPECT(!(rate2 < 0) && dt >= 0);  // not a number when the packing diverges
    const double least = 2 * allowance(s.radius_max);
    const double field = s.packing.L.norm() * (2 * s.radius_max + least) / least;
    s.packing.wear += dt * (std::sqrt(rate2) + field);
    return s.packing.wear >= 1;
}

}  // namespace sandgraph::dem

#include "dem/fast/neighbour_list.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/contracts.hpp"
#include "dem/fast/neighbours.hpp"
#include "dem/fast/packing.hpp"

namespace sandgraph::dem {
namespace {

void reduce(FastState& s, const Reduction& r) {
    const Mat2 U = r.U.cast<double>();
    s.H *= U, s.H_force *= U, s.LH *= U;
}

// The mean field moves with a wrapped grain: v -= L H k, so that v - L x stays.
void wrap_grains(FastState& s, std::vector<Wrapped>& moved) {
    const Mat2 inverse = s.H.inverse(), LH = s.L * s.H;
    moved.resize(s.grains);
    for (int g = 0; g < s.grains; ++g) {
        double* a = s.grain(g);
        moved[g] = wrap(s.H, inverse, a[0], a[1]);
        a[2] -= LH(0, 0) * moved[g].cx + LH(0, 1) * moved[g].cy;
        a[3] -= LH(1, 0) * moved[g].cx + LH(1, 1) * moved[g].cy;
    }
}

// Padding pairs join the padding grain with its far image (1, 1), too far for a force.
void pad(FastState& s, int slot) {
    s.i[slot] = s.j[slot] = static_cast<std::uint16_t>(s.grains);
    s.image[slot] = 8;
}

}  // namespace

void NeighbourList::rebuild(FastState& state) {
    contact_history(state, history_);
    relist(state, history_);
}

void NeighbourList::relist(FastState& s, const std::vector<Contact>& history) {
    SG_EXPECT(s.grains > 0 && s.H.determinant() != 0);
    const Reduction r = reduce_cell(s.H);
    if (!r.identity) reduce(s, r);
    wrap_grains(s, moved_);
    collect(s, history, r.U_inverse);
    list_pairs(s, search_.find(s.record.data(), s.grains, s.H, listed_gap(s.radius_max)));
    s.approach = 0;
    SG_ENSURE(s.slots % FastState::kLanes == 0 && s.inner % FastState::kLanes == 0);
    SG_ENSURE(s.inner <= s.pairs && s.pairs <= s.slots && !stale(s));
    SG_ENSURE(all_below(s.i, s.grains + 1) && all_below(s.j, s.grains + 1) && all_below(s.image, 9));
}

// Orders the history by first grain (i < j) with image counters in the new cell.
void NeighbourList::collect(const FastState& s, const std::vector<Contact>& history,
                            const Eigen::Matrix2i& U_inverse) {
    SG_EXPECT(moved_.size() == static_cast<std::size_t>(s.grains));
    first_.assign(s.grains + 1, 0);
    old_.resize(history.size());
    for (const Contact& c : history) ++first_[std::min(c.i, c.j) + 1];
    for (int g = 0; g < s.grains; ++g) first_[g + 1] += first_[g];
    for (const Contact& before : history) {
        Contact c = before;
        const Eigen::Vector2i image = U_inverse * Eigen::Vector2i(c.cell_x, c.cell_y);
        int cx = image.x() + moved_[c.j].cx - moved_[c.i].cx,
            cy = image.y() + moved_[c.j].cy - moved_[c.i].cy;
        if (c.i > c.j) std::swap(c.i, c.j), cx = -cx, cy = -cy, c.moment = -c.moment;
        c.cell_x = static_cast<std::int16_t>(cx), c.cell_y = static_cast<std::int16_t>(cy);
        old_[first_[c.i]++] = c;
    }
    std::rotate(first_.begin(), first_.end() - 1, first_.end());
    first_[0] = 0;
}

const Contact* NeighbourList::find(const NearPair& p) const {
    for (int k = first_[p.i]; k < first_[p.i + 1]; ++k) {
        const Contact& c = old_[k];
        if (c.j == p.j && c.cell_x == p.cell_x && c.cell_y == p.cell_y) return &c;
    }
    return nullptr;
}

// Pairs within the cell fill the first `inner` slots, so that most of the loop needs no image offsets; what
// does not fill the last lanes goes with the others.
void NeighbourList::list_pairs(FastState& s, const std::vector<NearPair>& pairs) {
    s.pairs = static_cast<int>(pairs.size());
    s.slots = padded(s.pairs);
    s.i.resize(s.slots), s.j.resize(s.slots), s.image.resize(s.slots);
    s.tangential.assign(s.slots, 0), s.moment.assign(s.slots, 0);
    inner_.clear(), outer_.clear();
    for (const NearPair& p : pairs) (p.cell_x == 0 && p.cell_y == 0 ? inner_ : outer_).push_back(p);
    s.inner = static_cast<int>(inner_.size()) / FastState::kLanes * FastState::kLanes;
    outer_.insert(outer_.end(), inner_.begin() + s.inner, inner_.end());
    inner_.resize(s.inner);
    deal(s, inner_, 0, s.inner);
    deal(s, outer_, s.inner, s.slots - s.inner);
}

// Consecutive pairs of the search share grains; dealing them out lane by lane keeps a grain's pairs apart in
// the pair loop, whose read-modify-write would otherwise wait on itself.
void NeighbourList::deal(FastState& s, const std::vector<NearPair>& pairs, int first, int slots) {
    const int stride = slots / FastState::kLanes;
    for (int k = 0; k < slots; ++k) {
        const int slot = first + (k % stride) * FastState::kLanes + k / stride;
        if (k >= static_cast<int>(pairs.size())) {
            pad(s, slot);
            continue;
        }
        const NearPair& p = pairs[k];
        s.i[slot] = static_cast<std::uint16_t>(p.i), s.j[slot] = static_cast<std::uint16_t>(p.j);
        s.image[slot] = static_cast<std::uint8_t>(3 * (p.cell_x + 1) + p.cell_y + 1);
        if (const Contact* c = find(p)) s.tangential[slot] = c->tangential, s.moment[slot] = c->moment;
    }
}

double NeighbourList::approach(const FastState& s, double speed2, double dt) const {
    SG_EXPECT(!(speed2 < 0) && dt > 0);  // not a number when the packing diverges
    return dt * (2 * std::sqrt(speed2) + s.L.norm() * (2 * s.radius_max + listed_gap(s.radius_max)));
}

}  // namespace sandgraph::dem

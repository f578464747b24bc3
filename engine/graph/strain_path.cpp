#include "graph/strain_path.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "base/contracts.hpp"
#include "stress/increment.hpp"

namespace sandgraph::graph {
namespace {

constexpr std::size_t kRecentMost = 16;

double dot(const Mat2& a, const Mat2& b) { return (a.array() * b.array()).sum(); }

void put(ByteWriter& out, const std::vector<Mat2>& list) {
    out.put(static_cast<std::uint64_t>(list.size()));
    for (const Mat2& m : list) out.put(std::span<const double>(m.data(), 4));
}

void take(ByteReader& in, std::vector<Mat2>& list) {
    std::uint64_t size = 0;
    in.take(size);
    require_state(size <= StrainPath::knots_max, "strain paths");
    list.resize(size);
    for (Mat2& m : list) in.take(std::span<double>(m.data(), 4));
}

}  // namespace

double strain_norm(const Mat2& F_inc) {
    const stress::Increment e = stress::increment(F_inc);
    return std::sqrt(e.xx * e.xx + e.yy * e.yy + 2 * e.xy * e.xy);
}

void StrainPath::begin(const Mat2& F) {
    SG_EXPECT(F.allFinite());
    clear();
    driven_ = latest_ = F;
}

void StrainPath::add(const Mat2& F) {
    if (!F.allFinite()) return;
    SG_EXPECT(F.determinant() > 0);
    if (knots_.size() + 1 >= knots_max) merge();
    extend(F);
}

void StrainPath::extend(const Mat2& F) {
    if (!near_chord(F) || recent_.size() >= kRecentMost) {
        knots_.push_back(latest_);
        recent_.clear();
    }
    // What lies close to a point kept is represented by it.
    const Mat2& kept = recent_.empty() ? last_knot() : recent_.back();
    if ((F - kept).squaredNorm() > 0.25 * tolerance_ * tolerance_) recent_.push_back(F);
    latest_ = F;
}

// Do the points passed lie within the tolerance of the chord from the last knot to `end`, in their order?
bool StrainPath::near_chord(const Mat2& end) const {
    const Mat2 chord = end - last_knot();
    const double length = chord.norm();
    const Mat2 direction = length > 0 ? Mat2(chord / length) : Mat2(Mat2::Zero());
    double furthest = 0;
    for (const Mat2& point : recent_) {
        const Mat2 from = point - last_knot();
        const double along = dot(from, direction);
        const double off = (from - along * direction).norm();
        furthest = std::max(furthest, along);
        if (off > tolerance_ || furthest - along > tolerance_ || along < -tolerance_) return false;
    }
    return furthest <= length + tolerance_;
}

void StrainPath::merge() {
    SG_EXPECT(tolerance_ > 0);
    while (knots_.size() > knots_max / 2) {
        tolerance_ *= 2;
        std::vector<Mat2> old;
        old.swap(knots_);
        old.push_back(latest_);
        recent_.clear();
        latest_ = driven_;
        for (const Mat2& F : old) extend(F);
    }
}

Mat2 StrainPath::advance(double budget) {
    SG_EXPECT(budget > 0);
    const Mat2 target = knots_.empty() ? latest_ : knots_.front(), inverse = driven_.inverse();
    const Mat2 whole = target * inverse;
    const double strain = strain_norm(whole);
    if (strain <= budget) {
        driven_ = target;
        if (knots_.empty())
            recent_.clear();
        else
            knots_.erase(knots_.begin());
        return whole;
    }
    const Mat2 next = driven_ + (budget / strain) * (target - driven_);
    // What was passed on the chord behind the new start counts no longer.
    if (knots_.empty()) recent_.assign(1, latest_);
    driven_ = next;
    return next * inverse;
}

void StrainPath::follow(const Place& place) {
    SG_EXPECT(place.knots <= knots_.size());
    const auto passed = static_cast<std::ptrdiff_t>(knots_.size() - place.knots);
    const Mat2 from = passed > 0 ? knots_[static_cast<std::size_t>(passed - 1)] : driven_;
    knots_.erase(knots_.begin(), knots_.begin() + passed);
    driven_ = place.driven;
    if (!knots_.empty() || driven_ == from) return;  // not on the last chord
    if (driven_ == latest_)
        recent_.clear();
    else
        recent_.assign(1, latest_);
}

void StrainPath::clear() {
    std::vector<Mat2>().swap(knots_);
    std::vector<Mat2>().swap(recent_);
}

void StrainPath::save(ByteWriter& out) const {
    out.put(tolerance_);
    out.put(std::span<const double>(driven_.data(), 4)), out.put(std::span<const double>(latest_.data(), 4));
    put(out, knots_), put(out, recent_);
}

void StrainPath::load(ByteReader& in) {
    in.take(tolerance_);
    in.take(std::span<double>(driven_.data(), 4)), in.take(std::span<double>(latest_.data(), 4));
    take(in, knots_), take(in, recent_);
}

}  // namespace sandgraph::graph

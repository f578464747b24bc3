#include "graph/visits.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/contracts.hpp"
#include "graph/stress_arithmetic.hpp"

namespace sandgraph::graph {
namespace {

// docs/how_it_works.md (eq. 31). Step-size control as for an ODE: the prediction's error grows about with the
// square of the change.
double next_admissible(double change, double error, const VisitSettings& settings) {
    const double factor =
        std::clamp(0.9 * std::sqrt(settings.update_tolerance / std::max(error, 1e-12)), 0.25, 2.0);
    SG_EXPECT(0.5 * settings.update_tolerance <= settings.update_change_max);
    return std::clamp(change * factor, 0.5 * settings.update_tolerance, settings.update_change_max);
}

}  // namespace

Visits::Visits(std::size_t points)
    : collected_(points, Mat2::Identity()),
      change_(points),
      admissible_(points, 0),
      waited_(points, 0),
      due_(points, 0),
      carried_(points, 0),
      secants_(points) {}

bool Visits::answered(std::int32_t point, double reference, double error, const VisitSettings& settings) {
    const auto p = static_cast<std::size_t>(point);
    SG_EXPECT(reference > 0 && !(error < 0));
    admissible_[p] = next_admissible(norm(change_[p]) / reference, error, settings);
    collected_[p].setIdentity();
    change_[p] = {};
    carried_[p] = 0;
    return std::exchange(waited_[p], std::uint8_t{0}) != 0;
}

void Visits::learn(std::int32_t point, const Stress& beyond, const PlaneModuli& moduli,
                   const VisitSettings& settings) {
    const auto p = static_cast<std::size_t>(point);
    if (settings.predictor == Predictor::elastic) return;
    if (!std::isfinite(norm(beyond)))
        secants_.forget(p);
    else if (carried_[p])
        secants_.learn_nothing(p);  // of what was carried over the strain is not collected any more
    else
        secants_.learn(p, collected_[p], beyond, moduli);
}

Stress Visits::carry(std::int32_t point, const Stress& rest, const PlaneModuli& moduli, double reference,
                     const VisitSettings& settings) {
    const auto p = static_cast<std::size_t>(point);
    SG_EXPECT(due_[p]);
    collected_[p].setIdentity();
    carried_[p] = waited_[p] = 1;
    Stress change = elastic_stress(moduli, rest);
    if (settings.predictor == Predictor::secant)
        change = difference(change, secants_.shortfall_ahead(p, rest));
    const double most = settings.update_change_max * reference, size = norm(change);
    return size > most ? scaled(most / size, change) : change;
}

void Visits::save(ByteWriter& out) const {
    out.put(change_), out.put(admissible_), out.put(waited_);
    out.put(carried_), secants_.save(out);
    for (const Mat2& F : collected_) out.put(std::span<const double>(F.data(), 4));
}

void Visits::load(ByteReader& in) {
    in.take_same(change_), in.take_same(admissible_), in.take_same(waited_);
    in.take_same(carried_), secants_.load(in);
    for (Mat2& F : collected_) in.take(std::span<double>(F.data(), 4));
}

}  // namespace sandgraph::graph

#pragma once
#include <algorithm>
#include <span>
#include <vector>

#include "base/byte_stream.hpp"
#include "graph/plane_moduli.hpp"
#include "graph/secant.hpp"
#include "graph/settings.hpp"
#include "graph/stress_arithmetic.hpp"

namespace sandgraph::graph {

// max(p, floor) [Pa].
inline double reference_pressure(const Stress& s, double floor) { return std::max(mean_stress(s), floor); }

// A law is asked for a point's stress only now and then: between two answers it is predicted.
// How far it may go before the next one is each point's own admissible change, which grows while predictions
// come true and shrinks where they do not, so that the error stays near the tolerance.
class Visits {
  public:
    explicit Visits(std::size_t points);

    // The step's increment: collects it, moves the stress `s` (unless the point floats), and notes whether
    // the law is due. Shares are of p, at least `floor` [Pa].
    void predict(std::int32_t point, const PlaneModuli& moduli, const Mat2& F_inc, bool floating,
                 const VisitSettings& settings, double floor, Stress& s);
    std::size_t size() const { return collected_.size(); }
    bool due(std::int32_t point) const { return due_[static_cast<std::size_t>(point)]; }
    const Mat2& collected(std::size_t point) const { return collected_[point]; }  // since the last answer
    std::span<const Mat2> collected() const { return collected_; }                // by point
    // Elastic change of the stress since the last answer, without rotation [Pa].
    const Stress& change(std::int32_t point) const { return change_[static_cast<std::size_t>(point)]; }
    // The law has answered with a stress of mean `reference` (at least the floor) [Pa]; `error`: of the
    // prediction, share of it. Returns whether the prediction had been used by a step before.
    bool answered(std::int32_t point, double reference, double error, const VisitSettings& settings);
    // Before `answered`, for the next predictions: the answer lay so far beyond this one [Pa].
    void learn(std::int32_t point, const Stress& beyond, const PlaneModuli& moduli,
               const VisitSettings& settings);
    // The packing took what was collected, but has still to follow the strain `rest`: it goes on in the next
    // step. What that will change of the stress it has come to, of mean `reference` (at least the floor)
    // [Pa]; as any prediction no more than a share of it.
    Stress carry(std::int32_t point, const Stress& rest, const PlaneModuli& moduli, double reference,
                 const VisitSettings& settings);

    void save(ByteWriter& out) const;
    void load(ByteReader& in);

  private:
    std::vector<Mat2> collected_;
    std::vector<Stress> change_;
    std::vector<double> admissible_;          // share of p; 0: the law's tolerance
    std::vector<std::uint8_t> waited_, due_;  // waited: the last step's stress was a prediction
    std::vector<std::uint8_t> carried_;       // the law is still at work on what it was asked
    Secants secants_;
};

// docs/how_it_works.md (eqs. 29 and 30). Here to be inlined: it runs for every point at every step.
inline void Visits::predict(std::int32_t point, const PlaneModuli& moduli, const Mat2& F_inc, bool floating,
                            const VisitSettings& settings, double floor, Stress& s) {
    const auto p = static_cast<std::size_t>(point);
    const Stress d = elastic_change(moduli, F_inc);
    collected_[p] = F_inc * collected_[p];
    Stress& change = change_[p];
    add(change, d);
    if (!floating) {
        turn(s, F_inc), add(s, d);
        if (settings.predictor == Predictor::secant) s = difference(s, secants_.shortfall(p, F_inc));
    }
    const double admissible = admissible_[p] > 0 ? admissible_[p] : settings.update_tolerance;
    // Not `change >= allowed`: a NaN must reach the law, which refuses it by name.
    due_[p] = carried_[p] || !(norm(change) < admissible * reference_pressure(s, floor));
    if (!due_[p]) waited_[p] = 1;
}

}  // namespace sandgraph::graph

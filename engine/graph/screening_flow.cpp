#include <cmath>

#include "base/byte_stream.hpp"
#include "graph/screening_law.hpp"
#include "graph/stress_arithmetic.hpp"

// Where sand flows, one packing's stress is weather: twins of it part by more than the surrogate is off, and
// these few points cost most of all DEM steps. Past GateSettings::flow a point goes back to the surrogate,
// which has followed its strain all the while.
namespace sandgraph::graph {
namespace {

// Members part more where sand flows, as twins of a packing do; a surrogate of noise parts by far more.
constexpr double kFlowSpread = 3;  // times the gate's threshold

void copy(const dem::Rve& from, dem::Rve& to) {
    std::vector<std::uint8_t> bytes;
    ByteWriter out(bytes);
    from.save(out);
    ByteReader in(bytes);
    to.load(in);
}

// A NaN compares as false.
bool usable(const stress::SurrogateAnswer& answer, double largest_spread) {
    return std::isfinite(norm(answer.stress)) && answer.spread <= largest_spread;
}

}  // namespace

bool ScreeningLaw::goes_back(std::int32_t p, const stress::SurrogateAnswer& followed) const {
    return mode_[p] == PointMode::grains && !rves_[p].floating() && reason_[p] != Reason::failed_answer &&
           deviatoric_strain(F_[p]) >= setup_.gate.flow && usable(followed, kFlowSpread * setup_.gate.spread);
}

void ScreeningLaw::hand_back(const stress::Batch& batch, double d_over_B) {
    for (std::size_t slot = 0; slot < followed_.size(); ++slot) {
        const std::int32_t p = followed_[slot];
        if (!goes_back(p, follower_answers_[slot])) continue;
        const Stress jump = difference(batch.stress[p], follower_answers_[slot].stress);
        start_fading(p, PointMode::flow, jump);
        --dem_points_;
        const double reference = reference_pressure(batch.stress[p], setup_.grains.options.pressure_floor);
        note({screening_.steps, d_over_B, p, Reason::flow, norm(jump) / reference});
        // Its audit goes on with the grains that have answered till now, whose stress it still has.
        if (const std::int32_t place = audit_of_[p]; place >= 0)
            copy(rves_[p], audit_rves_[place]), audit_errors_[place] = 0;
    }
}

}  // namespace sandgraph::graph

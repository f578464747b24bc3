#include "graph/screening/led_packings.hpp"

#include <Eigen/LU>
#include <array>
#include <cmath>

#include "base/contracts.hpp"
#include "graph/screening/pressure_lead.hpp"
#include "graph/stress_arithmetic.hpp"

namespace sandgraph::graph {
namespace {

constexpr double kPiece = 4e-4;     // strain of a piece of the path, after which the lead is looked at again
constexpr double kVisitStrain = 8;  // between two visits, in tolerances of the path
// Driven no faster than packings that answer: at three times the inertial number they told 5 % of the
// ground's work too much, with pieces of 1e-3 a tenth of a known bias too little.
constexpr int kMost = 20000;  // DEM steps of a packing in one step, so that no state can hold a run

}  // namespace

// Elastic predictions since then are taken off.
Stress Followed::at_last_answer(std::int32_t point) const {
    return difference(batch.stress[std::size_t(point)], visits.change(point));
}

std::span<const double> Followed::state(std::int32_t point) const {
    const std::size_t size = surrogate.state_size();
    return states.subspan(std::size_t(point) * size, size);
}

LedPackings::LedPackings(const std::vector<double>& tolerance, std::size_t state_size, std::size_t first_rve,
                         int steps)
    : replica_(tolerance.size()),
      from_grains_(tolerance.size(), 0),
      level_(tolerance.size(), 0),
      excess_(tolerance.size(), 0),
      shortfall_(tolerance.size()),
      state_size_(state_size),
      first_rve_(first_rve),
      steps_(steps) {
    SG_EXPECT(steps > 0);
    for (const double t : tolerance) paths_.emplace_back(t), visit_strain_.push_back(kVisitStrain * t);
}

void LedPackings::go_on_from_grains(std::int32_t point, const Mat2& F, std::span<const double> state) {
    const auto p = std::size_t(point);
    paths_[p].begin(F);
    replica_[p].assign(state.begin(), state.end());
    from_grains_[p] = 1, level_[p] = 0, excess_[p] = 0, shortfall_[p] = {};
}

void LedPackings::call(std::int32_t point, RvePool& pool) {
    const auto p = std::size_t(point);
    if (from_grains_[p]) pool.copy(p, rve(point)), from_grains_[p] = 0;
}

void LedPackings::dismiss(std::int32_t point, std::span<const double> state) {
    const auto p = std::size_t(point);
    if (level_[p]) replica_[p].assign(state.begin(), state.end());
    level_[p] = 0;
}

std::int64_t LedPackings::follow(std::span<const std::int32_t> points, const Followed& ground, RvePool& pool,
                                 std::int64_t& failures) {
    drives_.clear();
    for (const std::int32_t p : points)
        if (due(p)) drives_.push_back({p, level(p) ? kMost : steps_, 0, false});
    std::int64_t steps = 0;
    while (drive_pieces(ground, pool, steps, failures)) {
    }
    for (const Drive& drive : drives_) compare(drive, ground, pool);
    return steps;
}

bool LedPackings::due(std::int32_t point) const {
    const auto p = std::size_t(point);
    if (!level_[p]) return true;
    const Mat2 ahead = paths_[p].latest() * paths_[p].driven().inverse();
    return strain_norm(ahead) >= visit_strain_[p];
}

// The next piece of each path. Whether there was any.
bool LedPackings::drive_pieces(const Followed& ground, RvePool& pool, std::int64_t& steps,
                               std::int64_t& failures) {
    jobs_.clear(), driven_.clear();
    for (std::size_t k = 0; k < drives_.size(); ++k)
        if (drives_[k].left > 0 && !paths_[std::size_t(drives_[k].point)].done()) {
            jobs_.push_back(
                {.rve = rve(drives_[k].point), .increment = next_piece(drives_[k], ground, pool)});
            driven_.push_back(k);
        }
    answers_.resize(jobs_.size());
    pool.drive(jobs_, answers_);
    for (std::size_t slot = 0; slot < jobs_.size(); ++slot) {
        Drive& drive = drives_[driven_[slot]];
        const dem::RveReport& report = answers_[slot].report;
        steps += report.dem_steps, failures += failed(report.status);
        drive.left -= std::max(1, report.dem_steps);
        drive.moved = true;
        const double excess = mean_stress(tension_positive(answers_[slot].stress)) - drive.target;
        excess_[std::size_t(drive.point)] = std::isfinite(excess) ? excess : 0;
    }
    return !jobs_.empty();
}

// docs/how_it_works.md (eq. 41b).
Mat2 LedPackings::next_piece(Drive& drive, const Followed& ground, const RvePool& pool) {
    const auto p = std::size_t(drive.point);
    const Mat2 F_inc = paths_[p].advance(kPiece);
    drive.target = level_[p] ? mean_stress(ground.at_last_answer(drive.point))
                             : replica_pressure(drive.point, F_inc, ground, pool);
    const double floor = ground.grains.options.pressure_floor;
    const double pressure = std::fmax(floor, drive.target);
    const auto row = std::size_t(ground.grains.packing_of_point[p]);
    return opened(F_inc, giving_way(excess_[p], ground.grains.packing(p).moduli.bulk,
                                    std::fmax(floor, ground.traits[row].pressure), pressure));
}

// Of the surrogate, sent along the piece as the point was [Pa].
double LedPackings::replica_pressure(std::int32_t point, const Mat2& F_inc, const Followed& ground,
                                     const RvePool& pool) {
    std::vector<double>& state = replica_[std::size_t(point)];
    if (state.empty()) {
        state.resize(state_size_);
        const auto row = std::size_t(ground.grains.packing_of_point[std::size_t(point)]);
        ground.surrogate.start(ground.traits[row], tension_positive(pool.stress(rve(point))), state);
    }
    constexpr std::array<std::int32_t, 1> only{0};
    std::array<stress::SurrogateAnswer, 1> answer;
    ground.surrogate.update(only, std::span(&F_inc, 1), state, answer);
    return mean_stress(answer[0].stress);
}

void LedPackings::compare(const Drive& drive, const Followed& ground, const RvePool& pool) {
    const auto p = std::size_t(drive.point);
    if (!paths_[p].done() || (level_[p] && !drive.moved)) return;
    if (!level_[p]) replica_[p] = {}, paths_[p].clear();
    level_[p] = 1;
    const Stress now = ground.at_last_answer(drive.point);
    const Stress grains = tension_positive(pool.stress(rve(drive.point)));
    shortfall_[p] = difference(grains, now);
    excess_[p] = mean_stress(grains) - mean_stress(now);
    if (!std::isfinite(norm(shortfall_[p]))) shortfall_[p] = {}, excess_[p] = 0;
}

void LedPackings::save(ByteWriter& out) const {
    for (std::size_t p = 0; p < paths_.size(); ++p) paths_[p].save(out), out.put(replica_[p]);
    out.put(from_grains_), out.put(level_), out.put(excess_), out.put(shortfall_);
}

void LedPackings::load(ByteReader& in) {
    for (std::size_t p = 0; p < paths_.size(); ++p) {
        paths_[p].load(in), in.take(replica_[p]);
        require_state(replica_[p].empty() || replica_[p].size() == state_size_, "audited points");
    }
    in.take_same(from_grains_), in.take_same(level_), in.take_same(excess_), in.take_same(shortfall_);
}

}  // namespace sandgraph::graph

#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace sandgraph::stress {

// Why a point was handed from the surrogate to its grains, or back. Files keep the names below.
enum class Reason : std::uint8_t {
    none,
    strain,
    stress_ratio,
    tension,
    distance,
    spread,
    second_order_work,
    acoustic_tensor,
    failed_answer,   // not finite, or absurd
    neighbour,       // of a point that was handed over
    critical_state,  // back from its grains to the surrogate
};
inline constexpr std::size_t reason_count = 11;
inline constexpr std::array<const char*, reason_count> reason_names = {"none",
                                                                       "strain",
                                                                       "stress ratio",
                                                                       "tension",
                                                                       "distance",
                                                                       "spread",
                                                                       "second-order work",
                                                                       "acoustic tensor",
                                                                       "failed answer",
                                                                       "neighbour",
                                                                       "flow"};

// One point handed from the surrogate to its grains, or back (Reason::critical_state).
struct Switch {
    std::int64_t step = 0;
    double d_over_B = 0;
    std::int32_t point = 0;
    Reason reason = Reason::none;
    double jump = 0;  // |sigma_surrogate - sigma_DEM|, share of max(p_DEM, floor)
    // Largest change of the ground's stress in one step while the jump fades, and in as many steps after it,
    // shares of max(p, floor); NaN: no such step, or not recorded.
    double felt = std::numeric_limits<double>::quiet_NaN(), ordinary = felt;
};

// What an audit says of the points that the surrogate answers for: the mean over them of
// |sigma_surrogate - sigma_DEM|/max(p_DEM, 1 kPa), 1 at most, where the packing has been driven along
// the point's own strain path. It does not see what the error has done to that path.
struct AuditRow {
    double d_over_B = 0;
    double points = 0;      // in the sample
    double population = 0;  // points that the surrogate answers for
    double mean = 0;        // NaN without a sample
    double ci95 = 0;        // half width of the 95 % confidence interval of the mean; NaN without a sample
};

// What auditors of the load say of a stretch of the run: the work that grains would have taken beyond what
// the ground's stresses took along the same strain, sum of V (sigma_grains - sigma) : d(eps), of the modelled
// part.
struct VirtualWork {
    double missing = 0;   // an estimate [J/m]
    double variance = 0;  // of it, by the draw of the auditors [(J/m)^2]
};

struct ScreeningCounters {
    std::int64_t steps = 0, surrogate_updates = 0, failed_answers = 0;
    // DEM steps of packings that do not answer.
    std::int64_t replay_steps = 0, shadow_steps = 0, audit_steps = 0, load_audit_steps = 0;
    double dem_points = 0;  // summed over the steps: points that the grains answer for
    double jump_work = 0;   // energy that the fading jumps put into the ground: sum of jump : d(eps) V [J/m]
};

// What a law that chooses between surrogate and grains has done so far.
struct ScreeningLog {
    std::vector<Switch> switches;
    std::vector<AuditRow> audits;
    ScreeningCounters counters;
};

}  // namespace sandgraph::stress

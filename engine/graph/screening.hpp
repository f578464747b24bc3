#pragma once
#include <array>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "graph/gate.hpp"
#include "graph/rve_law.hpp"
#include "graph/stress_audit.hpp"
#include "graph/visits.hpp"
#include "stress/surrogate.hpp"

namespace sandgraph::graph {

// Who answers for a point. Only onwards: surrogate -> ... -> grains -> flow.
enum class PointMode : std::uint8_t {
    surrogate,  // the surrogate; the point's packing stands as it was at the start
    replay,     // the surrogate; the packing is being driven along the point's recorded path
    shadow,     // the surrogate; the packing has caught up and follows
    blending,   // the packing, with a rest of the stress jump at the switch
    grains,     // the packing
    flow,       // the surrogate again, past the strain where sand flows; it has followed the grains
};

struct ScreeningSetup : ScreeningSettings {
    RveLawSetup grains;
    std::shared_ptr<const stress::Surrogate> surrogate;
    std::vector<stress::PackingTraits> traits;  // of each row's packing
};

// One point handed from the surrogate to its grains, or back (Reason::flow).
struct Switch {
    std::int64_t step = 0;
    double d_over_B = 0;
    std::int32_t point = 0;
    Reason reason = Reason::none;
    double jump = 0;  // |sigma_surrogate - sigma_DEM|, share of max(p_DEM, floor)
    // Largest change of the ground's stress in one step while the jump fades, and in as many steps after it,
    // shares of max(p, floor); NaN: no such step.
    double felt = std::numeric_limits<double>::quiet_NaN(), ordinary = felt;
};

struct ScreeningCounters {
    std::int64_t steps = 0, surrogate_updates = 0, failed_answers = 0;
    std::int64_t replay_steps = 0, shadow_steps = 0, audit_steps = 0;  // DEM steps of packings that do not
                                                                       // answer
    double dem_points = 0;  // summed over the steps: points that the grains answer for
    double jump_work = 0;   // energy that the fading jumps put into the ground: sum of jump : d(eps) V [J/m]
};

// Where the points are, for what a law cannot know from stress and strain.
struct Surroundings {
    std::span<const double> x, y, volume;  // by point [m], [m], [m2]; empty: no neighbours, no energy count
    double cell = 1;                       // [m]
    double d_over_B = 0;
};

}  // namespace sandgraph::graph

#pragma once
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/archive.hpp"
#include "base/tensor.hpp"
#include "stress/screening_log.hpp"
#include "stress/stage.hpp"

namespace sandgraph::dem {
class Rve;
struct RveUpdate;
}  // namespace sandgraph::dem

namespace sandgraph::stress {

// What a point can tell of itself, whatever law answers for it.
struct Observation {
    double porosity = std::numeric_limits<double>::quiet_NaN();  // 2D; NaN: the law knows none
    const dem::Rve* packing = nullptr;                           // that answers for the point, or audits it
    bool by_grains = false;                                      // the packing answers
    std::uint8_t mode = 0;                                       // constitutive mode: code of run.h5
    // The audit's stress error, share of p; NaN where no audit looks.
    double audited_error = std::numeric_limits<double>::quiet_NaN();
};

// What a law does with grains; zeros for closed-form laws.
struct GrainUse {
    std::int64_t active = 0;     // full fidelity: points that own a packing; screening: answered by grains
    std::int64_t dem_steps = 0;  // of all packings since the start, shadows and audits included
    std::int64_t updates = 0, failures = 0;  // of the packings that answer
};

// Which fields its points can fill.
enum class Answers : std::uint8_t { formula, grains, screening };

// The law of the ground's material: the one interface between mpm and what stands behind it.
class Law {
  public:
    virtual ~Law() = default;
    // Initial stress of the points in `batch.points` (F_inc unused): what the law holds before any strain.
    virtual void initialise(const Batch& batch) = 0;
    // Must give the same bits for any split of the points into batches and any thread count.
    virtual void update(const Batch& batch) = 0;
    // The same work as stages that a step graph runs. By default one stage: update.
    virtual std::vector<Stage> stages();
    // Largest P-wave modulus [Pa], for the time step.
    virtual double p_wave_modulus() const = 0;
    virtual void archive(Archive&) {}

    // What it tells. Nothing of this changes an answer.
    virtual Answers answers() const { return Answers::formula; }
    virtual Observation observe(std::size_t) const { return {}; }
    virtual GrainUse grain_use() const { return {}; }
    // Named figures of its own for summaries.
    virtual std::vector<std::pair<std::string, double>> figures() const { return {}; }
    virtual const ScreeningLog* screening_log() const { return nullptr; }  // null: it does not screen
    virtual AuditRow audit() const { return {}; }                          // of this moment
    // Does it measure what its stresses' errors do to the load?
    virtual bool audits_load() const { return false; }
    // Since it was last taken.
    virtual VirtualWork take_missing_work() { return {}; }
    // Records the DEM updates of these points from now on, or of those that the law prefers: returns which.
    // Empty: it has no grains to watch.
    virtual std::vector<std::int32_t> watch(std::span<const std::int32_t>) { return {}; }
    // Those of the last step, in an order that hangs on no thread.
    virtual void each_watched_update(const std::function<void(const dem::RveUpdate&)>&) const {}
    // The run has gone all the way.
    virtual void conclude(double /*d_over_B*/) {}
};

}  // namespace sandgraph::stress

#pragma once
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "dem/rve.hpp"
#include "graph/strain_path.hpp"

namespace sandgraph::graph {

// What a packing is to be driven through: some way along a recorded path, if there is one, and where that has
// come to its end, or there is none, through an increment.
struct RveJob {
    std::size_t rve = 0;            // in the pool; in one call each packing once
    std::optional<Mat2> increment;  // F_inc, lab frame
    StrainPath* path = nullptr;     // advanced as far as the packing gets
    int path_steps = 0;             // DEM steps along the path after which it stops for now
    bool observed = false;          // the answer holds what the packing shows
    bool may_wait = false;          // RveOptions::steps_max holds: the report may be of an unfinished update
};

struct RveAnswer {
    dem::RveReport report;       // DEM steps of all its pieces; the worst status among them
    Mat2 stress = Mat2::Zero();  // after it [Pa], compression positive, lab frame, not symmetrised
    Mat2 to_follow = Mat2::Zero();  // strain of an unfinished update that the stress does not know of yet, lab frame
    double volume_ratio = 1;     // J since the start
    bool caught_up = false;      // its path, if it had one, is driven to the end
    std::optional<dem::Observables> seen;
};

// The owner of every RVE. Where one lives is its concern alone: callers know a packing by its number, hand in
// increments and get stresses.
class RvePool {
  public:
    virtual ~RvePool() = default;

    // Drives the packings in parallel, begun in the order of the jobs: give the longest first.
    virtual void drive(std::span<const RveJob> jobs, std::span<RveAnswer> answers) = 0;

    std::size_t size() const { return floating_.size(); }
    // It carries nothing: its stress is zero and stays so while it opens. Not virtual: asked for every point.
    bool floating(std::size_t rve) const { return floating_[rve] != 0; }
    virtual Mat2 stress(std::size_t rve) const = 0;             // as RveAnswer::stress
    virtual double strain_per_step(std::size_t rve) const = 0;  // that a DEM step of the next drive covers
    virtual double porosity(std::size_t rve) const = 0;
    virtual void copy(std::size_t from, std::size_t to) = 0;  // both of one initial packing
    virtual std::size_t owning() const = 0;                   // packings that have been driven

    // For output.
    virtual const dem::Rve& rve(std::size_t rve) const = 0;

    virtual void save(ByteWriter& out) const = 0;
    virtual void load(ByteReader& in) = 0;  // StateError for what is no state of these packings

  protected:
    std::vector<std::uint8_t> floating_;  // by packing; whoever drives keeps it
};

// All packings in this process. `initial` [packings]: what each starts from.
std::unique_ptr<RvePool> local_pool(const std::vector<std::shared_ptr<const dem::CompactPacking>>& initial,
                                    const dem::Material& material, const dem::RveOptions& options);

}  // namespace sandgraph::graph

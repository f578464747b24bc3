#pragma once
#include <span>
#include <vector>

#include "graph/rve_law.hpp"
#include "graph/strain_path.hpp"
#include "stress/surrogate.hpp"

namespace sandgraph::graph {

// What packings follow: the ground that the surrogate answers for, as it stands after a step.
struct Followed {
    const stress::Batch& batch;
    const Visits& visits;
    std::span<const Mat2> F;                        // by point: since the start, at its last answer
    std::span<const double> states;                 // of the surrogate [point x state_size]
    std::span<const stress::PackingTraits> traits;  // of each of grains.packings
    const RveLawSetup& grains;
    const stress::Surrogate& surrogate;

    Stress at_last_answer(std::int32_t point) const;  // of the ground [Pa], tension positive
    std::span<const double> state(std::int32_t point) const;
};

// Packings that can be put behind any point at any time and then stand where the ground stands, but with a
// volume that gives way until their mean stress is the ground's (pressure-led, pressure_lead.hpp). A packing
// that is called late is driven along the point's recorded path; the pressure that leads it there is told by
// the surrogate, which goes the same way once more.
class LedPackings {
  public:
    // They are those of the pool from `first_rve` on, one for each point. `tolerance`: of a point's recorded
    // path, as a strain. `state_size`: of the surrogate. `steps`: DEM steps a packing catches up by in a step
    // of the ground.
    LedPackings(const std::vector<double>& tolerance, std::size_t state_size, std::size_t first_rve,
                int steps);

    void record(std::int32_t point, const Mat2& F) { paths_[std::size_t(point)].add(F); }
    const Mat2& recorded(std::int32_t point) const { return paths_[std::size_t(point)].latest(); }
    // Grains have answered for the point till now and stand at F: its packing is to go on from theirs.
    void go_on_from_grains(std::int32_t point, const Mat2& F, std::span<const double> state);

    void call(std::int32_t point, RvePool& pool);
    void dismiss(std::int32_t point, std::span<const double> state);  // it stays where it is
    bool level(std::int32_t point) const { return level_[std::size_t(point)] != 0; }
    // sigma_grains - sigma, when they were last compared [Pa], tension positive.
    const Stress& shortfall(std::int32_t point) const { return shortfall_[std::size_t(point)]; }
    Stress& shortfall(std::int32_t point) { return shortfall_[std::size_t(point)]; }

    // Drives the packings of these points, each once, as far as they may go. Returns their DEM steps.
    std::int64_t follow(std::span<const std::int32_t> points, const Followed& ground, RvePool& pool,
                        std::int64_t& failures);

    void save(ByteWriter& out) const;
    void load(ByteReader& in);

  private:
    std::size_t rve(std::int32_t point) const { return first_rve_ + std::size_t(point); }
    struct Drive {
        std::int32_t point;
        int left;       // DEM steps that it may still take
        double target;  // mean stress where its piece ends [Pa]
        bool moved;
    };
    bool due(std::int32_t point) const;
    bool drive_pieces(const Followed& ground, RvePool& pool, std::int64_t& steps, std::int64_t& failures);
    Mat2 next_piece(Drive& drive, const Followed& ground, const RvePool& pool);
    double replica_pressure(std::int32_t point, const Mat2& F_inc, const Followed& ground,
                            const RvePool& pool);
    void compare(const Drive& drive, const Followed& ground, const RvePool& pool);

    std::vector<StrainPath> paths_;             // by point: what its packing has still to be driven along
    std::vector<double> visit_strain_;          // by point: between two visits of a packing that is level
    std::vector<std::vector<double>> replica_;  // by point: surrogate's state where the packing stands;
                                                // empty: at the start
    std::vector<std::uint8_t> from_grains_;     // by point: the packing is still to be copied
    std::vector<std::uint8_t> level_;           // by point: called, and has caught up
    std::vector<double> excess_;     // by point: mean stress of the packing over that which leads it [Pa]
    std::vector<Stress> shortfall_;  // by point
    std::size_t state_size_, first_rve_;
    int steps_;

    // Of this step.
    std::vector<Drive> drives_;
    std::vector<std::size_t> driven_;  // in drives_, by slot of jobs_
    std::vector<RveJob> jobs_;
    std::vector<RveAnswer> answers_;
};

}  // namespace sandgraph::graph

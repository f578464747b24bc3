#pragma once
#include <tbb/enumerable_thread_specific.h>

#include <memory>
#include <vector>

#include "dem/packing/observe.hpp"
#include "dem/rve.hpp"
#include "graph/visits.hpp"
#include "stress/law.hpp"

namespace sandgraph::graph {

// The packing that all points of one depth row start from.
struct RowPacking {
    std::shared_ptr<const dem::CompactPacking> packing;
    PlaneModuli moduli;
};

struct RveLawSetup {
    dem::Material material;
    dem::RveOptions options;
    std::vector<RowPacking> rows;
    std::vector<std::int32_t> row_of_point;  // [points]
    VisitSettings visits = {};
};

// StateError when the archive is of a run that started from other packings: another machine's rounding, or
// another version of the program, makes others by the same recipe.
void confirm_packings(Archive& a, const std::vector<RowPacking>& rows);

struct RveCounters {
    std::int64_t dem_steps = 0, updates = 0, failures = 0;
    std::int64_t predicted = 0;  // updates of points whose stress had been a prediction for a step or more
    double prediction_error_sum = 0;  // over those: |predicted - DEM|/max(p, floor), an upper bound on what
                                      // the ground saw
    double inertial_number_max = 0;
};

// What a DEM update of a watched point did, for the history log.
struct RveUpdate {
    std::int32_t point = 0;
    Mat2 F_inc = Mat2::Identity();  // since the point's previous update, with its spin
    dem::RveReport report;
    Mat2 stress = Mat2::Zero();  // after it [Pa], compression positive, lab frame, not symmetrised
    double volume_ratio = 1;     // J since the start
    dem::Observables seen;       // lab frame
};

// A packing of grains at every material point, behind the stress contract. Between two DEM updates a point's
// stress follows its small-strain stiffness. How far that prediction may move the stress before the grains
// are asked is each point's own allowance: it grows while predictions come true and shrinks where they do
// not, so that the error stays near the tolerance. Quiet points cost nothing and own no packing.
class RveLaw : public stress::Law {
  public:
    explicit RveLaw(RveLawSetup setup);
    void initialise(const stress::Batch& batch) override;
    void update(const stress::Batch& batch) override;  // predict, route, drive in turn
    double p_wave_modulus() const override;
    void archive(Archive& a) override;

    // The three stages, for the step graph.
    void predict(const stress::Batch& batch);  // all points: stress and collected deformation
    void route(const stress::Batch& batch);    // which points need their grains, longest expected first
    void drive(const stress::Batch& batch);    // DEM updates, in parallel; stress to owned slots

    const RveCounters& counters() const { return counters_; }
    // The DEM updates of the last step in the order they were started, longest expected first.
    const std::vector<dem::RveReport>& last_reports() const { return reports_; }
    // Records every DEM update of these points from now on.
    void watch(std::span<const std::int32_t> points);
    const std::vector<RveUpdate>& watched_updates() const { return watched_; }  // of the last step
    std::size_t owning() const;                                                 // points that own a packing
    const dem::Rve& rve(std::size_t point) const { return rves_[point]; }
    // Deformation since the last DEM update is not in the packing yet; this includes it.
    double porosity(std::size_t point) const;
    // What the point's packing shows as it was left by its last DEM update, in the lab frame.
    dem::Observables observe(std::size_t point) const { return dem::observe(rves_[point], setup_.material); }

  private:
    struct Due {
        std::int32_t point;
        double expected_steps;
    };
    void drive_point(std::size_t slot, const stress::Batch& batch);
    void assign_records();
    void record(std::size_t slot, const Mat2& F_inc);

    RveLawSetup setup_;
    Visits visits_;
    std::vector<dem::Rve> rves_;
    std::vector<Due> due_;
    std::vector<dem::RveReport> reports_;                         // by slot of due_
    std::vector<double> errors_;                                  // by slot of due_
    std::vector<std::uint8_t> waited_;                            // by slot of due_: Visits::answered
    std::vector<std::uint8_t> watch_;                             // by point
    std::vector<RveUpdate> watched_;                              // in the order of due_
    std::vector<std::int32_t> record_of_;                         // by slot of due_: in watched_, or -1
    tbb::enumerable_thread_specific<dem::Workspace> workspaces_;  // scratch, no state
    RveCounters counters_;
};

}  // namespace sandgraph::graph

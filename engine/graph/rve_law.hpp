#pragma once
#include <memory>
#include <vector>

#include "graph/rve_pool.hpp"
#include "graph/visits.hpp"
#include "stress/law.hpp"

namespace sandgraph::graph {

// A packing that points of one depth row start from.
struct RowPacking {
    std::shared_ptr<const dem::CompactPacking> packing;
    PlaneModuli moduli;
};

struct RveLawSetup {
    dem::Material material;
    dem::RveOptions options;
    std::vector<RowPacking> packings;
    std::vector<std::int32_t> packing_of_point;  // [points] index in `packings`
    VisitSettings visits = {};
    PoolMaker make_pool = local_pool;

    const RowPacking& packing(std::size_t point) const {
        return packings[static_cast<std::size_t>(packing_of_point[point])];
    }
    double p_wave_modulus() const;  // largest of the packings [Pa]
    // What the packing of each point starts from.
    InitialPackings initial_packings() const;
};

// StateError when the archive is of a run that started from other packings: another machine's rounding, or
// another version of the program, makes others by the same recipe.
void confirm_packings(Archive& a, const std::vector<RowPacking>& packings);

struct RveCounters {
    std::int64_t dem_steps = 0, updates = 0, failures = 0;
    std::int64_t predicted = 0;  // updates of points whose stress had been a prediction for a step or more
    double prediction_error_sum = 0;  // over those: |predicted - DEM|/max(p, floor), an upper bound on what
                                      // the ground saw
    double inertial_number_max = 0;

    // One answer; `waited`: its stress had been a prediction, off by `error`.
    void count(const dem::RveReport& report, bool waited, double error);
};

// The update of a watched point, of an answer that was observed.
dem::RveUpdate update_of(std::int32_t point, const RveJob& job, const RveAnswer& answer);

// The stress of a point whose packing goes on following it in the next step [Pa], tension positive: what the
// grains have come to, and a prediction of the rest.
Stress stress_on_the_way(const RveAnswer& answer, Visits& visits, std::int32_t point,
                         const RveLawSetup& setup);

// A packing of grains at every material point, behind the stress contract. Between two DEM updates a point's
// stress follows its small-strain stiffness. How far that prediction may move the stress before the grains
// are asked is each point's own admissible change: it grows while predictions come true and shrinks where
// they do not, so that the error stays near the tolerance. Quiet points cost nothing and own no packing.
class RveLaw : public stress::Law {
  public:
    explicit RveLaw(RveLawSetup setup);
    void initialise(const stress::Batch& batch) override;
    void update(const stress::Batch& batch) override;  // its stages in turn
    std::vector<stress::Stage> stages() override;
    double p_wave_modulus() const override { return setup_.p_wave_modulus(); }
    void archive(Archive& a) override;

    void predict(const stress::Batch& batch);  // all points: stress and collected deformation
    void route(const stress::Batch& batch);    // which points need their grains, longest expected first
    void drive(const stress::Batch& batch);    // DEM updates, in parallel; stress to owned slots

    stress::Answers answers() const override { return stress::Answers::grains; }
    stress::Observation observe(std::size_t point) const override;
    stress::GrainUse grain_use() const override;
    std::vector<std::pair<std::string, double>> figures() const override;
    std::vector<std::int32_t> watch(std::span<const std::int32_t> points) override;
    void each_watched_update(const std::function<void(const dem::RveUpdate&)>& tell) const override;

    const RveCounters& counters() const { return counters_; }
    // The DEM updates of the last step in the order they were started, longest expected first.
    std::span<const RveAnswer> last_answers() const { return {answers_.data(), jobs_.size()}; }
    std::size_t owning() const { return pool_->owning(); }  // points that own a packing
    const dem::Rve& rve(std::size_t point) const { return pool_->rve(point); }

  private:
    void settle(std::size_t slot, const stress::Batch& batch);

    RveLawSetup setup_;
    Visits visits_;
    std::unique_ptr<RvePool> pool_;      // packing k is that of point k
    std::vector<std::uint8_t> watched_;  // by point; empty: none
    RveCounters counters_;

    // Of this step.
    struct Due {
        std::int32_t point;
        double expected_steps;
    };
    std::vector<Due> due_;
    std::vector<RveJob> jobs_;        // by slot of due_
    std::vector<RveAnswer> answers_;  // by slot of due_
    struct Prediction {
        double error = 0;     // share of p
        bool waited = false;  // the ground has used it
    };
    std::vector<Prediction> predictions_;  // by slot of due_
};

}  // namespace sandgraph::graph

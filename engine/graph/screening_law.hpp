#pragma once
#include "graph/felt_jumps.hpp"
#include "graph/screening.hpp"
#include "graph/strain_path.hpp"
#include "stress/increment.hpp"

namespace sandgraph::graph {

// The learned surrogate where it can be trusted, packings of grains where it cannot, behind the stress
// contract. A point starts with the surrogate and records its strain path; the gate looks at every answer and
// has the packing driven along that path in time, then hands over, fading the stress jump. Some points drawn
// at random carry a second packing that only measures the surrogate's error: with any audit the ground moves
// bit for bit the same.
class ScreeningLaw : public stress::Law {
  public:
    explicit ScreeningLaw(ScreeningSetup setup);
    void initialise(const stress::Batch& batch) override;
    void update(const stress::Batch& batch) override;  // all stages in turn, without surroundings
    double p_wave_modulus() const override;
    void archive(Archive& a) override;

    // The stages, for the step graph. `ask` and `drive` may run at the same time.
    void predict(const stress::Batch& batch);  // all points: stress and collected deformation
    void route(const stress::Batch& batch);    // who is asked: surrogate, packings, shadows, audits
    void ask(const stress::Batch& batch);      // answers of the surrogate, to owned slots
    void drive(const stress::Batch& batch);    // DEM updates, longest expected first
    // Writes the surrogate's stresses, judges them, switches points and fades their jumps; audits when due.
    void hand_over(const stress::Batch& batch, const Surroundings& around);

    AuditRow audit() const;           // of this moment
    void audit_now(double d_over_B);  // adds it to audits()
    const std::vector<AuditRow>& audits() const { return audits_; }
    const std::vector<Switch>& switches() const { return switches_; }
    const RveCounters& counters() const { return counters_; }  // of the packings that answer
    const ScreeningCounters& screening() const { return screening_; }
    std::int64_t dem_steps() const;  // of all packings, shadows and audits included
    PointMode mode(std::size_t point) const { return mode_[point]; }
    bool by_grains(std::size_t point) const {
        return mode_[point] == PointMode::blending || mode_[point] == PointMode::grains;
    }
    // That answers for the point or audits its answers; none where the surrogate is alone.
    const dem::Rve* packing(std::size_t point) const;
    std::size_t grain_points() const { return dem_points_; }
    std::size_t size() const { return mode_.size(); }
    double porosity(std::size_t point) const;
    // The history log follows the audited packings: full fidelity along the strain that the surrogate led to.
    void watch_audits() { watching_ = true; }
    const std::vector<std::int32_t>& audited() const { return audited_; }
    const std::vector<RveUpdate>& watched_updates() const { return watched_; }  // of the last step
    // The audit's stress error of a point that the surrogate answers for; NaN where nobody looks.
    double audited_error(std::size_t point) const;

  private:
    enum class Task : std::uint8_t { answer, follow, replay, audit };
    struct Job {
        std::int32_t point;
        Task task;
        double expected_steps;
    };
    struct Outcome {
        dem::RveReport report{};
        double error = 0;        // of the prediction (answer), share of p
        bool waited = false;     // it had been used (answer)
        bool caught_up = false;  // replay
        double reference = 0;    // mean stress that shares are of (answer) [Pa]
    };
    void save(ByteWriter& out) const;
    void load(ByteReader& in);
    void require_sound() const;
    const RowPacking& row(std::int32_t point) const;
    const stress::PackingTraits& traits(std::int32_t point) const;
    void predict_point(std::int32_t point, const stress::Batch& batch);
    void add_visit(std::int32_t point);
    void add_job(std::int32_t point, Task task, const dem::Rve& rve, double strain);
    dem::RveReport advance(dem::Rve& rve, const Mat2& F_inc);

    Outcome run(const Job& job, const stress::Batch& batch);
    void assign_records();
    void record(std::size_t slot);
    Outcome answer(std::int32_t point, const stress::Batch& batch);
    Outcome replay(std::int32_t point);
    void count(const Job& job, const Outcome& outcome);
    dem::RveReport drive_to_end(std::int32_t point);

    void settle_grains();
    void settle_answers(const stress::Batch& batch);
    void settle_answer(std::size_t slot, const stress::Batch& batch);
    void ask(const std::vector<std::int32_t>& points, std::vector<stress::SurrogateAnswer>& answers);
    bool absurd(const stress::SurrogateAnswer& answer, std::int32_t point, const Stress& predicted) const;
    Verdict judge_answer(std::size_t slot, const Stress& predicted) const;
    double acoustic_share(std::int32_t point, const stress::Increment& e) const;
    void settle_replays();
    void raise(const Surroundings& around);
    void raise_neighbours(const std::vector<std::int32_t>& centres, const Surroundings& around);
    void replace_failed();
    void switch_ready(const stress::Batch& batch, double d_over_B);
    void switch_point(std::int32_t point, const stress::Batch& batch, double d_over_B);
    void fade(const stress::Batch& batch, const Surroundings& around);
    void hand_back(const stress::Batch& batch, double d_over_B);
    bool goes_back(std::int32_t point, const stress::SurrogateAnswer& followed) const;
    void start_fading(std::int32_t point, PointMode mode, const Stress& jump);
    void note(const Switch& one);

    ScreeningSetup setup_;
    Visits visits_;
    std::vector<PointMode> mode_;
    std::vector<Reason> reason_;  // by point: why it shall be handed over
    std::vector<Mat2> F_;  // by point: since the start, at its last answer (by grains: if they may go back)
    std::vector<StrainPath> paths_;  // by point
    std::vector<double> states_;     // of the surrogate [point x state_size]
    std::vector<dem::Rve> rves_;
    std::vector<Stress> blend_;            // by point: the rest of its jump, part of its stress
    std::vector<std::int32_t> fade_left_;  // by point: steps

    std::vector<std::int32_t> audited_;   // points of the sample
    std::vector<std::int32_t> audit_of_;  // by point: its place in the sample, or -1
    std::vector<dem::Rve> audit_rves_;    // by place
    std::vector<double> audit_errors_;    // by place
    bool watching_ = false;
    std::vector<RveUpdate> watched_;       // in the order of jobs_
    std::vector<std::int32_t> record_of_;  // by slot of jobs_: in watched_, or -1

    std::vector<std::int32_t> asked_;               // of the surrogate, this step
    std::vector<stress::SurrogateAnswer> answers_;  // by slot of asked_
    std::vector<Verdict> verdicts_;                 // by slot of asked_
    std::vector<std::int32_t> followed_;            // by grains, due in this step: the surrogate goes along
    std::vector<stress::SurrogateAnswer> follower_answers_;  // by slot of followed_
    std::vector<Job> jobs_;
    std::vector<Outcome> outcomes_;                               // by slot of jobs_
    std::vector<std::uint8_t> caught_up_;                         // by point: in this step
    tbb::enumerable_thread_specific<dem::Workspace> workspaces_;  // scratch, no state

    std::vector<std::int32_t> fading_;  // points whose jump fades
    std::size_t dem_points_ = 0;
    double next_audit_ = 0;
    std::vector<AuditRow> audits_;
    std::vector<Switch> switches_;
    FeltJumps felt_;
    RveCounters counters_;
    ScreeningCounters screening_;
};

}  // namespace sandgraph::graph

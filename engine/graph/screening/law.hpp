#pragma once
#include <memory>
#include <vector>

#include "graph/rve_law.hpp"
#include "graph/screening/audit.hpp"
#include "graph/screening/auditors.hpp"
#include "graph/screening/blend.hpp"
#include "graph/screening/felt_jumps.hpp"
#include "graph/screening/gate.hpp"
#include "graph/screening/modes.hpp"
#include "stress/increment.hpp"
#include "stress/surrogate.hpp"

namespace sandgraph::graph {

using stress::Surroundings;

struct ScreeningSetup : ScreeningSettings {
    RveLawSetup grains;
    std::shared_ptr<const stress::Surrogate> surrogate;
    std::vector<stress::PackingTraits> traits;  // of each of grains.packings
};

// The learned surrogate where it can be trusted, packings of grains where it cannot, behind the stress
// contract. A point starts with the surrogate and records its strain path; the gate looks at every answer and
// has the packing driven along that path in time, then hands over, fading the stress jump (modes.hpp has the
// whole life of a point). Some points drawn at random carry a second packing that only measures the
// surrogate's error: with any audit the ground moves bit for bit the same.
class ScreeningLaw : public stress::Law {
  public:
    explicit ScreeningLaw(ScreeningSetup setup);
    void initialise(const stress::Batch& batch) override;
    void update(const stress::Batch& batch) override;  // its stages in turn
    std::vector<stress::Stage> stages() override;
    double p_wave_modulus() const override { return setup_.grains.p_wave_modulus(); }
    void archive(Archive& a) override;

    // The stages. `ask` and `drive` may run at the same time.
    void predict(const stress::Batch& batch);    // all points: stress and collected deformation
    void route(const stress::Batch& batch);      // who is asked: surrogate, packings, shadows, audits
    void ask();                                  // answers of the surrogate, to owned slots
    void drive();                                // DEM updates, longest expected first
    void hand_over(const stress::Batch& batch);  // answers become stresses, points change hands

    stress::Answers answers() const override { return stress::Answers::screening; }
    stress::Observation observe(std::size_t point) const override;
    stress::GrainUse grain_use() const override;
    const stress::ScreeningLog* screening_log() const override { return &log_; }
    AuditRow audit() const override;
    bool audits_load() const override { return auditors_.present(); }
    stress::VirtualWork take_missing_work() override { return auditors_.take(); }
    // The history log follows the audited packings, whatever is asked for: full fidelity along the strain
    // that the surrogate led to.
    std::vector<std::int32_t> watch(std::span<const std::int32_t> points) override;
    void each_watched_update(const std::function<void(const dem::RveUpdate&)>& tell) const override;
    void conclude(double d_over_B) override { audit_now(d_over_B); }

    void audit_now(double d_over_B);                           // adds the audit of this moment to the log
    const RveCounters& counters() const { return counters_; }  // of the packings that answer
    const Modes& modes() const { return modes_; }
    const Auditors& auditors() const { return auditors_; }
    std::size_t size() const { return modes_.size(); }

  private:
    friend struct ScreeningStages;  // tests call the stages of hand_over one by one

    enum class Task : std::uint8_t { answer, follow, replay, audit };
    struct Job {
        std::int32_t point;
        Task task;
        double expected_steps;
    };
    std::size_t audit_rve(std::int32_t place) const { return size() + static_cast<std::size_t>(place); }
    const stress::PackingTraits& traits(std::size_t point) const;

    std::span<const double> state(std::int32_t point) const {  // of the surrogate
        const std::size_t each = setup_.surrogate->state_size();
        return std::span(states_).subspan(static_cast<std::size_t>(point) * each, each);
    }
    double floor() const { return setup_.grains.options.pressure_floor; }  // of pressures in shares [Pa]
    void predict_point(std::int32_t point, const stress::Batch& batch);
    void add_visit(std::int32_t point);
    void add_job(std::int32_t point, Task task, std::size_t rve, double strain);
    RveJob rve_job(const Job& job);
    void ask(const std::vector<std::int32_t>& points, std::vector<stress::SurrogateAnswer>& answers);

    // hand_over.cpp: the stages of hand_over in their order.
    void note_followed_strain();
    void settle_grains(const stress::Batch& batch);
    void settle_grain_answer(std::size_t slot, const stress::Batch& batch);
    void fade_jumps(const stress::Batch& batch);
    void settle_answers(const stress::Batch& batch);
    void settle_answer(std::size_t slot, const stress::Batch& batch);
    void settle_replays();
    void raise(const Surroundings& around);
    void replace_failed();
    void switch_ready(const stress::Batch& batch);
    void hand_back(const stress::Batch& batch);
    void audit_load(const stress::Batch& batch);
    double missing_under_jumps(const stress::Batch& batch) const;
    void close_step(double d_over_B);

    void raise_neighbours(const std::vector<std::int32_t>& centres, const Surroundings& around);
    bool absurd(const stress::SurrogateAnswer& answer, std::int32_t point, const Stress& predicted) const;
    Verdict judge_answer(std::size_t slot, const Stress& predicted) const;
    double acoustic_share(std::int32_t point, const stress::Increment& e) const;
    bool goes_back(std::int32_t point, const stress::SurrogateAnswer& followed) const;
    void note(const stress::Switch& one);

    void save(ByteWriter& out) const;
    void load(ByteReader& in);
    void require_sound() const;

    ScreeningSetup setup_;
    Visits visits_;
    Modes modes_;
    StressBlend blend_;
    AuditSample audit_;
    FeltJumps felt_;
    // Packing k is that of point k, then the audit's by place, then the auditors' by point.
    std::unique_ptr<RvePool> pool_;
    Auditors auditors_;
    std::vector<Mat2> F_;  // by point: since the start, at its last answer (by grains: if they may go back)
    std::vector<StrainPath> paths_;  // by point
    std::vector<double> states_;     // of the surrogate [point x state_size]
    RveCounters counters_;
    stress::ScreeningLog log_;
    bool watching_ = false;

    // Of this step.
    std::vector<std::int32_t> asked_;                        // of the surrogate
    std::vector<stress::SurrogateAnswer> answers_;           // by slot of asked_
    std::vector<Verdict> verdicts_;                          // by slot of asked_
    std::vector<std::int32_t> followed_;                     // by grains, due: the surrogate goes along
    std::vector<stress::SurrogateAnswer> follower_answers_;  // by slot of followed_
    std::vector<Job> jobs_;
    std::vector<RveJob> rve_jobs_;         // by slot of jobs_
    std::vector<RveAnswer> rve_answers_;   // by slot of jobs_
    std::vector<std::uint8_t> caught_up_;  // by point
};

}  // namespace sandgraph::graph

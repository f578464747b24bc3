#pragma once
#include "tests/unit/graph/screening_bench.hpp"

namespace sandgraph::graph {

// A screening law whose stages of hand_over can be called one by one, on a state set by hand.
struct ScreeningStages {
    explicit ScreeningStages(std::size_t points, ScreeningSetup setup = setup_of(1, 1))
        : bench{points, law_of(points, std::move(setup))},
          law(bench.law),
          modes(law.modes_),
          blend(law.blend_),
          F(law.F_) {}

    static ScreeningLaw law_of(std::size_t points, ScreeningSetup setup) {
        setup.grains.packing_of_point.assign(points, 0);
        return ScreeningLaw(std::move(setup));
    }

    // The answers of one step, by hand: whom the surrogate was asked for and what the gate says of it.
    void judged(std::vector<std::int32_t> points, std::vector<Verdict> verdicts) {
        law.asked_ = std::move(points), law.verdicts_ = std::move(verdicts);
        law.answers_.resize(law.asked_.size());
    }
    void followed(std::int32_t point, const stress::SurrogateAnswer& answer) {
        law.followed_ = {point}, law.follower_answers_ = {answer};
    }
    void lead_to(PointMode wanted, std::size_t point) {
        for (const ModeEvent event : {ModeEvent::near_gate, ModeEvent::caught_up, ModeEvent::handed_over,
                                      ModeEvent::faded, ModeEvent::flows})
            if (modes[point] != wanted) modes.apply(point, event);
    }
    // The point at (x, y); cells are one wide.
    Surroundings around() { return {bench.x, bench.y, bench.volume, 1, 0.25}; }
    void place(std::size_t point, double x, double y) { bench.x[point] = x, bench.y[point] = y; }
    stress::Batch batch() {
        stress::Batch out = bench.batch();
        out.around = around();
        return out;
    }
    // Drives a point's path, stress and collected deformation through F_inc without a law's answer.
    void predict(std::int32_t point, const Mat2& F_inc) {
        bench.F[static_cast<std::size_t>(point)] = F_inc;
        law.predict_point(point, bench.batch());
    }

    void raise() { law.raise(around()); }
    void replace_failed() { law.replace_failed(); }
    void switch_ready() { law.switch_ready(batch()); }
    void hand_back() { law.hand_back(batch()); }
    void fade_jumps() { law.fade_jumps(batch()); }
    void close_step(double d_over_B) { law.close_step(d_over_B); }
    void note_followed_strain() { law.note_followed_strain(); }
    Verdict judge_answer(const stress::SurrogateAnswer& answer, const Stress& predicted) {
        law.answers_ = {answer};
        return law.judge_answer(0, predicted);
    }
    bool absurd(const stress::SurrogateAnswer& answer, std::int32_t point, const Stress& predicted) const {
        return law.absurd(answer, point, predicted);
    }

    StrainPath& path(std::size_t point) { return law.paths_[point]; }
    RvePool& pool() { return *law.pool_; }
    void settle_replays(std::int32_t point, bool caught_up) {
        law.jobs_ = {{point, ScreeningLaw::Task::replay, 0}};
        law.caught_up_[static_cast<std::size_t>(point)] = caught_up;
        law.settle_replays();
    }
    void settle_grains(std::int32_t point, const RveAnswer& answer) {
        law.jobs_ = {{point, ScreeningLaw::Task::answer, 0}}, law.rve_answers_ = {answer};
        law.settle_grains(batch());
    }
    void settle_answer(std::int32_t point, const stress::SurrogateAnswer& answer) {
        law.asked_ = {point}, law.answers_ = {answer};
        law.settle_answers(batch());
    }
    // The points of the jobs that `route` plans, in the order in which they are begun.
    std::vector<std::int32_t> planned() {
        law.route(batch());
        std::vector<std::int32_t> out;
        for (const ScreeningLaw::Job& job : law.jobs_) out.push_back(job.point);
        return out;
    }
    const Verdict& verdict() const { return law.verdicts_.front(); }
    stress::ScreeningLog& log() { return law.log_; }
    const RveCounters& counters() const { return law.counters_; }
    bool due(std::int32_t point) const { return law.visits_.due(point); }
    const Stress& change(std::int32_t point) const { return law.visits_.change(point); }

    Bench<ScreeningLaw> bench;
    ScreeningLaw& law;
    Modes& modes;
    StressBlend& blend;
    std::vector<Mat2>& F;
};

}  // namespace sandgraph::graph

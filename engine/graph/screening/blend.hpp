#pragma once
#include <span>
#include <vector>

#include "base/byte_stream.hpp"
#include "base/tensor.hpp"

namespace sandgraph::graph {

// Tension cut-off: what of `rest` sand can bear on top of the stress that its law answers [Pa]: all, a half,
// a quarter ... or nothing, such that nothing pulls.
Stress tension_cut_off(const Stress& answered, Stress rest);

// The stress jumps of points that were switched from one law to another, while they fade:
// sigma = sigma_new + w (sigma_old - sigma_new at the switch), w: 1 -> 0 in equal steps.
class StressBlend {
  public:
    StressBlend(std::size_t points, int steps) : rest_(points), steps_left_(points, 0), steps_(steps) {}

    // A point may be switched again before its last jump is gone: `jump` then holds what was left of it.
    void start(std::int32_t point, const Stress& jump);
    bool fading(std::size_t point) const { return steps_left_[point] > 0; }
    const Stress& rest(std::size_t point) const { return rest_[point]; }  // part of the point's stress [Pa]
    // The rest turns with the point. Owned slots, so any thread may.
    void turn(std::int32_t point, const Mat2& F_inc);
    // The stress of a point whose law has just answered: with the rest, cut off where it would pull.
    Stress on_top_of(const Stress& answered, std::size_t point);

    // One step: takes each point's share off `stress` [by point, Pa]. Adds the work that the jumps did on the
    // ground, sum of rest : d(eps) V [J/m], to `work` (nothing without volumes). Points with nothing left are
    // in ended().
    void fade(std::span<const Mat2> F_inc, std::span<const double> volume, std::span<Stress> stress,
              double& work);
    const std::vector<std::int32_t>& ended() const { return ended_; }
    const std::vector<std::int32_t>& points() const { return fading_; }  // whose jumps fade now

    void save(ByteWriter& out) const;
    void load(ByteReader& in);

  private:
    std::vector<Stress> rest_;              // by point
    std::vector<std::int32_t> steps_left_;  // by point
    std::vector<std::int32_t> fading_;      // points, in the order of their switches
    std::vector<std::int32_t> ended_;       // in the last step
    int steps_;
};

}  // namespace sandgraph::graph

#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "base/byte_stream.hpp"
#include "stress/screening_log.hpp"

namespace sandgraph::graph {

using stress::Reason;

// The constitutive mode of a point: who gives its stress.
enum class PointMode : std::uint8_t {
    surrogate,       // the surrogate; the point's packing stands as it was at the start
    replay,          // the surrogate; the packing is being driven along the point's recorded path
    shadow,          // the surrogate; the packing has caught up and follows
    blending,        // the packing, with a rest of the stress jump at the switch
    grains,          // the packing
    critical_state,  // the surrogate again, in critical-state shear; it has followed the grains
};
inline constexpr std::size_t mode_count = 6;
// As files name them, in the order of their codes.
inline constexpr std::array<const char*, mode_count> mode_names{"surrogate", "replay", "shadow",
                                                                "blending",  "grains", "critical_state"};

enum class ModeEvent : std::uint8_t {
    near_gate,      // a measure passes the low threshold, or a neighbour passes the gate
    caught_up,      // the packing stands where its point stands
    handed_over,    // the gate has asked for the grains, and they are ready
    faded,          // nothing is left of the jump
    flows,          // past the strain of critical-state shear
    answer_failed,  // the surrogate's answer cannot be used: the packing catches up at once
};

struct Transition {
    PointMode from;
    ModeEvent on;
    PointMode to;
};

// The life of a point, whole. What is not in this table cannot happen.
inline constexpr std::array<Transition, 9> transitions = {{
    {PointMode::surrogate, ModeEvent::near_gate, PointMode::replay},
    {PointMode::replay, ModeEvent::caught_up, PointMode::shadow},
    {PointMode::shadow, ModeEvent::handed_over, PointMode::blending},
    {PointMode::blending, ModeEvent::faded, PointMode::grains},
    {PointMode::grains, ModeEvent::flows, PointMode::critical_state},
    {PointMode::surrogate, ModeEvent::answer_failed, PointMode::shadow},
    {PointMode::replay, ModeEvent::answer_failed, PointMode::shadow},
    {PointMode::shadow, ModeEvent::answer_failed, PointMode::shadow},
    {PointMode::critical_state, ModeEvent::answer_failed, PointMode::shadow},
}};

inline bool answers_by_grains(PointMode mode) {
    return mode == PointMode::blending || mode == PointMode::grains;
}

// The modes of all points, and why each shall be handed over.
class Modes {
  public:
    Modes(std::size_t points, PointMode start);

    std::size_t size() const { return mode_.size(); }
    PointMode operator[](std::size_t point) const { return mode_[point]; }
    bool by_grains(std::size_t point) const { return answers_by_grains(mode_[point]); }
    std::size_t grain_points() const { return grain_points_; }  // how many the grains answer for

    bool allows(std::size_t point, ModeEvent event) const;  // is there a way on from the point's mode?
    void apply(std::size_t point, ModeEvent event);         // std::logic_error where there is none

    Reason reason(std::size_t point) const { return reason_[point]; }
    void set_reason(std::size_t point, Reason reason) { reason_[point] = reason; }

    void save(ByteWriter& out) const;
    void load(ByteReader& in);  // StateError for codes that are none

  private:
    std::vector<PointMode> mode_;
    std::vector<Reason> reason_;
    std::size_t grain_points_ = 0;
};

}  // namespace sandgraph::graph

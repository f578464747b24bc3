#pragma once
#include <algorithm>

#include "base/contracts.hpp"
#include "base/tensor.hpp"
#include "dem/grain_scale.hpp"

namespace sandgraph::dem {

// Holds one stress component at a target by a strain rate: proportional-integral, strain and stress
// compression positive. `modulus` [Pa] turns stress into strain, `response` [s] is the time an error takes to
// decay, `memory` [s] the time of the integral part (0: none), `limit` [1/s] bounds the rate.
class StressServo {
  public:
    StressServo(double modulus, double response, double memory, double limit)
        : gain_(1 / (modulus * response)), memory_(memory), limit_(limit) {
        SG_EXPECT(modulus > 0 && response > 0 && limit > 0);
    }

    // Strain rate [1/s] for the next `interval` [s]; `missing` = target - measured stress [Pa].
    double rate(double missing, double interval) {
        SG_EXPECT(interval > 0 || memory_ <= 0);
        if (memory_ > 0)
            integral_ = std::clamp(integral_ + gain_ * missing * interval / memory_, -limit_, limit_);
        return std::clamp(gain_ * missing + integral_, -limit_, limit_);
    }

  private:
    double gain_, memory_, limit_, integral_ = 0;
};

// The servo of tests that strain a sample at `rate` [1/s] while it holds a stress; tuned on the dense and
// loose reference packings for the smallest rms error.
inline constexpr int quick_servo_interval = 2;  // steps
inline StressServo quick_servo(const GrainScale& grains, double rate) {
    return {grains.modulus, 1e-4 * grains.slowness, 1e-3 * grains.slowness, 20 * rate};
}

}  // namespace sandgraph::dem

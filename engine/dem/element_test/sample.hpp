#pragma once
#include "dem/element_test/element_test.hpp"

namespace sandgraph::dem {

// A sample on the test stand: drives the assembly and keeps the books of step, time and F in the row
// convention.
class SampleOnStand {
  public:
    SampleOnStand(Assembly& assembly, double dt);
    void step(const Mat2& L, int count);
    ElementRow row();

    Assembly& assembly() { return assembly_; }
    std::int64_t steps() const { return steps_; }
    double dt() const { return dt_; }
    Mat2 F() const { return F_; }
    Mat2 periods() const { return F_ * H_0_; }

  private:
    Assembly& assembly_;
    double dt_;
    Mat2 H_0_, F_ = Mat2::Identity(), L_last_ = Mat2::Zero();
    std::int64_t steps_ = 0;
};

// Fills in what a test leaves to the grains (0).
void by_grains(double& pressure, double& rate, double& time_step, const GrainScale& grains);

}  // namespace sandgraph::dem

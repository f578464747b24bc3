#pragma once
#include <vector>

#include "dem/assembly.hpp"
#include "dem/fast/state.hpp"
#include "dem/mixed/list.hpp"
#include "dem/mixed/state.hpp"

namespace sandgraph::dem {

// The mixed-precision kernel behind the Assembly interface, in YADE's order within a step. The last move of a
// call waits for the next one, so that what is looked at in between belongs to the forces.
class MixedAssembly : public Assembly {
  public:
    MixedAssembly(const Packing& packing, const Material& material);
    void step(const Mat2& L, double dt, int count) override;
    Mat2 stress() override { return stress_; }
    Observables observe() override;
    Mat2 cell() const override { return state_.packing.H; }
    Packing packing() const override;
    void set_friction(double tangent) override { constants_.friction = tangent; }
    int pairs() const { return state_.packing.pairs; }
    long rebuilds() const { return rebuilds_; }

  private:
    Material material_;
    KernelConstants constants_;
    std::vector<int> order_;  // grain k of state_ is grain order_[k] of the packing
    std::vector<double> radii_;
    MixedState state_;
    MixedList list_;
    Mat2 stress_ = Mat2::Zero();
    double waiting_ = 0;  // time step of the move that waits
    long rebuilds_ = 0;
};

}  // namespace sandgraph::dem

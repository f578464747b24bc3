#pragma once
#include "dem/assembly.hpp"
#include "dem/fast/kernel.hpp"
#include "dem/fast/neighbour_list.hpp"
#include "dem/fast/packing.hpp"

namespace sandgraph::dem {

// The fast kernel behind the Assembly interface, in YADE's order within a step. For element tests and packing
// preparation; the RVEs of a run share working states instead (rve.hpp).
class FastAssembly : public Assembly {
  public:
    FastAssembly(const Packing& packing, const Material& material);
    void step(const Mat2& L, double dt, int count) override;
    Mat2 stress() override { return stress_; }
    Observables observe() override;
    Mat2 cell() const override { return state_.H_force; }
    Packing packing() const override;
    void set_friction(double tangent) override { constants_.friction = tangent; }
    int pairs() const { return state_.pairs; }
    long rebuilds() const { return rebuilds_; }

  private:
    Material material_;
    KernelConstants constants_;
    std::vector<int> order_;  // grain k of state_ is grain order_[k] of the packing
    FastState state_;
    NeighbourList neighbours_;
    Mat2 stress_ = Mat2::Zero();
    double dt_ = 0;
    long rebuilds_ = 0;
};

}  // namespace sandgraph::dem

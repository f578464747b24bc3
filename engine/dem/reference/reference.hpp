#pragma once
#include <vector>

#include "dem/assembly.hpp"
#include "dem/packing/observe.hpp"
#include "dem/reference/contact.hpp"
#include "dem/reference/pairs.hpp"

namespace sandgraph::dem {

// The published DEM step, arithmetic as written (YADE to round-off); the yardstick of every faster kernel.
// Positions are never wrapped, the cell is never re-reduced. A packing that is given with contact history
// goes on from it, with the tangential forces laid on the normals of the first step; its pending cell motion
// `L` is advanced with the dt of the first step.
class ReferenceAssembly : public Assembly {
  public:
    ReferenceAssembly(const Packing& packing, const Material& material);

    void step(const Mat2& L, double dt, int count) override;
    Mat2 stress() override;
    Observables observe() override;
    Mat2 cell() const override { return H_; }
    Packing packing() const override;
    void set_friction(double tangent) override;

    // Contacts of the last force evaluation, sorted by (i, j, cell); before the first step, as the packing
    // lies.
    std::vector<ContactForce> contacts() const;

  private:
    struct Pair {
        PairKey key;
        PairConstants constants;
        ContactState contact;
        bool restored = false;  // history given, but no normal to turn it from yet
    };

    void one_step(const Mat2& L, double dt);
    void move_cell();
    void apply_forces(double dt);
    void advance_pair(Pair& pair, double dt);
    void move_grains(const Mat2& L, double dt);
    void restore_history(const std::vector<Contact>& contacts);
    bool list_is_valid(double fluctuation) const;
    void refresh_pairs();
    void rebuild_pairs();
    double largest_fluctuation() const;

    Material material_;
    double tan_phi_, r_max_, skin_;
    Mat2 H_, LH_ = Mat2::Zero(), L_;
    double last_dt_ = 0;
    bool evaluated_ = false;
    std::vector<double> r_, mass_, spin_, torque_;
    std::vector<Vec2> x_, v_, force_;

    std::vector<Pair> pairs_;           // Verlet list
    std::vector<Vec2> listed_x_;        // positions when it was built
    Mat2 listed_F_ = Mat2::Identity();  // deformation since then
    double fluctuation_bound_ = 0;      // of non-affine displacements since then [m]
};

}  // namespace sandgraph::dem

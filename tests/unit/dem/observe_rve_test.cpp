#include <gtest/gtest.h>

#include "dem/fast/fast.hpp"
#include "dem/packing/csv.hpp"
#include "dem/packing/observe.hpp"
#include "dem/rve.hpp"
#include "dem/stretch.hpp"
#include "tests/support/table1_options.hpp"
#include "yade_reference.hpp"

namespace sandgraph::dem {
namespace {

// The public dense packing, sheared to near its peak while it turns.
Rve sheared() {
    FastAssembly a(read_packing_csv(test::yade_file("packing_dense_p32.csv")), Material{});
    a.step(Mat2::Zero(), 1e-5, 4000);
    Rve rve(compact(a.packing(), Material{}, a.stress()));
    Workspace work;
    const Mat2 stretch = (Mat2() << 1 + 1e-4, 0, 0, 1 - 1e-4).finished();
    for (int k = 0; k < 60; ++k)
        rve.update(rotation(0.01) * stretch, Material{}, support::table1_options(), work);
    return rve;
}

// Its grains as the mixed kernel knows them, radii rounded.
Packing shown(const Rve& rve) {
    Packing p = to_packing(rve.packing());
    for (double& r : p.r) r = static_cast<float>(r);
    return p;
}

// The long way: every pair searched anew, contacts sorted.
Observables searched(const Rve& rve) {
    const Packing p = shown(rve);
    return observe(p, contact_forces(p, Material{}), Material{});
}

TEST(ObserveRve, PairListHoldsTheContactsThatASearchFinds) {
    const Rve rve = sheared();
    const Observables listed = observe(rve, Material{}), all = searched(rve);
    EXPECT_EQ(listed.contacts, all.contacts);
    EXPECT_EQ(listed.coordination, all.coordination);
    EXPECT_EQ(listed.mechanical_coordination, all.mechanical_coordination);
    EXPECT_EQ(listed.sliding_fraction, all.sliding_fraction);
    const auto near = [](double a, double b) { EXPECT_NEAR(a, b, 1e-7 * std::abs(b)); };
    near(listed.unbalanced, all.unbalanced);
    near(listed.elastic_normal, all.elastic_normal);
    near(listed.elastic_tangential, all.elastic_tangential);
    near(listed.elastic_rolling, all.elastic_rolling);
    near(listed.kinetic_translation, all.kinetic_translation);
    near(listed.kinetic_rotation, all.kinetic_rotation);
    near(listed.anisotropy, all.anisotropy);
    near(listed.porosity, all.porosity);
}

TEST(ObserveRve, StressAndFabricTurnWithThePoint) {
    const Rve rve = sheared();
    const Observables listed = observe(rve, Material{}), all = searched(rve);
    EXPECT_LT((listed.fabric - turned(all.fabric, rve.angle())).norm(), 1e-12);
    EXPECT_GT((listed.fabric - all.fabric).norm(), 1e-3);
    EXPECT_EQ(listed.stress, rve.stress());
    EXPECT_LT((all.stress - rve.packing().stress).norm(), 1e-4 * all.stress.norm());
}

// Positions at rest are rounded; contacts at the Coulomb limit must still be told from the others.
TEST(ObserveRve, SlidingIsSeenThroughTheRoundingOfAPackingAtRest) {
    const Rve rve = sheared();
    const double share = observe(rve, Material{}).sliding_fraction;
    EXPECT_GT(share, 0.02);
    EXPECT_LT(share, 0.5);
    int limited = 0, contacts = 0;
    const Packing p = shown(rve);
    const double tan_phi = std::tan(Material{}.friction_angle);
    for (const ContactForce& c : contact_forces(p, Material{})) {
        ++contacts;
        limited += c.f_t.norm() > (1 - 1e-4) * tan_phi * c.f_n;
    }
    EXPECT_NEAR(share, double(limited) / contacts, 0.003);
}

}  // namespace
}  // namespace sandgraph::dem

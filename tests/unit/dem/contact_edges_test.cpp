#include <gtest/gtest.h>

#include <cmath>

#include "dem/fast/fast.hpp"
#include "dem/fast/neighbour_list.hpp"
#include "dem/reference/contact.hpp"

// The first step of a contact, the list's bound, and whose moment a history is.
namespace sandgraph::dem {
namespace {

// In the total form the rotation counts from where the contact was found, in increments from the step before.
TEST(ContactLaw, TheStepOfBirthTurnsAContactInIncrementsOnly) {
    Material material;
    const PairConstants pair(0.005, 0.004, material);
    const PairMotion motion{Vec2(0.0089, 0), Vec2::Zero(), 0, 0, 1e-7};
    for (const RollingForm form : {RollingForm::incremental, RollingForm::total}) {
        ContactState t;
        ASSERT_TRUE(advance(t, pair, motion, 0.4, form, 1e-5));
        EXPECT_NEAR(t.moment, form == RollingForm::incremental ? -pair.k_r * 1e-7 : 0, 1e-12 * pair.k_r);
        ASSERT_TRUE(advance(t, pair, motion, 0.4, form, 1e-5));
        EXPECT_NEAR(t.moment, -pair.k_r * (form == RollingForm::incremental ? 2e-7 : 1e-7), 1e-12 * pair.k_r);
    }
}

// Twice the fastest grain's way, and the mean field over the longest listed distance.
TEST(NeighbourList, BoundsHowMuchCloserGrainsCanHaveCome) {
    FastState state;
    state.radius_max = 0.007, state.L << 3, 0, 0, -4;
    const NeighbourList list;
    EXPECT_NEAR(list.approach(state, 0.25, 1e-3), 1e-3 * (2 * 0.5 + 5 * (0.014 + listed_gap(0.007))), 1e-15);
}

TEST(FastAssembly, AContactGivenFromTheOtherGrainHasTheOtherMoment) {
    Packing packing;
    packing.H = Mat2::Identity() * 0.06;
    packing.x = {0.02, 0.0298}, packing.y = {0.02, 0.02}, packing.r = {0.005, 0.005};
    Packing other = packing;
    packing.contacts = {{0, 1, 0, 0, 3.0, 0.002}};
    other.contacts = {{1, 0, 0, 0, 3.0, -0.002}};
    const Contact a = FastAssembly(packing, {}).packing().contacts.at(0);
    const Contact b = FastAssembly(other, {}).packing().contacts.at(0);
    EXPECT_EQ(a.moment, 0.002);
    EXPECT_EQ(b.moment, a.moment);
    EXPECT_EQ(b.tangential, a.tangential);
    EXPECT_EQ(b.i, a.i);
}

}  // namespace
}  // namespace sandgraph::dem

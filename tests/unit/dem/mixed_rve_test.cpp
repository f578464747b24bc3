#include <gtest/gtest.h>

#include <span>

#include "dem/packing/csv.hpp"
#include "dem/packing/observe.hpp"
#include "dem/rve.hpp"
#include "tests/support/public_packing.hpp"
#include "tests/support/table1_options.hpp"
#include "yade_reference.hpp"

namespace sandgraph::dem {
namespace {

struct MixedRve : testing::Test {
    MixedRve() { options.kernel = RveKernel::mixed; }
    RveReport drive(Rve& rve, const Mat2& F) { return rve.update(F, {}, options, work); }
    void shear(Rve& rve, int updates) {
        for (int k = 0; k < updates; ++k)
            ASSERT_EQ(drive(rve, (Mat2() << 1, 2e-4, 0, 1).finished()).status, RveStatus::ok);
    }
    RveOptions options = support::table1_options();
    Workspace work;
    Rve rve{support::public_packing().packing};
};

std::vector<std::uint8_t> bytes_of(const Rve& rve) {
    std::vector<std::uint8_t> bytes;
    ByteWriter out(bytes);
    rve.save(out);
    return bytes;
}

TEST_F(MixedRve, AnswersAsTheDoubleKernelDoes) {
    Rve other(support::public_packing().packing);
    RveOptions in_double = options;
    in_double.kernel = RveKernel::double_precision;
    const Mat2 F = (Mat2() << 1 - 1e-5, 4e-5, 0, 1 - 2e-5).finished();
    for (int k = 0; k < 3; ++k) drive(rve, F), other.update(F, {}, in_double, work);
    EXPECT_LE((rve.stress() - other.stress()).norm(), 1e-4 * other.stress().norm());
    EXPECT_NEAR(rve.porosity(), other.porosity(), 1e-12);
}

TEST_F(MixedRve, GoesOnFromACheckpointToTheBit) {
    shear(rve, 20);
    const std::vector<std::uint8_t> bytes = bytes_of(rve);
    Rve again(support::public_packing().packing);
    ByteReader in(bytes);
    again.load(in);
    EXPECT_TRUE(in.empty());
    Workspace fresh;
    shear(rve, 20);
    std::swap(fresh, work);
    shear(again, 20);
    EXPECT_EQ(rve.stress(), again.stress());
    EXPECT_EQ(bytes_of(rve), bytes_of(again));
}

TEST_F(MixedRve, StartsFromAConvertedPackingWithTheSameBits) {
    Rve other(in_mixed_form(support::public_packing().packing));
    EXPECT_EQ(other.stress(), rve.stress());
    EXPECT_EQ(other.porosity(), rve.porosity());
    shear(rve, 5), shear(other, 5);
    EXPECT_EQ(bytes_of(rve), bytes_of(other));
}

TEST_F(MixedRve, RefusesADamagedCheckpoint) {
    shear(rve, 2);
    const std::vector<std::uint8_t> sound = bytes_of(rve);
    for (std::size_t at = 0; at < sound.size(); at += 97) {
        std::vector<std::uint8_t> bytes = sound;
        bytes[at] ^= 0xFF;
        Rve again(support::public_packing().packing);
        ByteReader in(bytes);
        try {
            again.load(in);
            drive(again, (Mat2() << 1, 2e-4, 0, 1).finished());  // what is let in must not crash
        } catch (const StateError&) {
        }
    }
    Rve again(support::public_packing().packing);
    ByteReader half(std::span<const std::uint8_t>(sound).first(sound.size() / 2));
    EXPECT_THROW(again.load(half), StateError);
}

TEST_F(MixedRve, DoesNotDependOnWhatTheWorkspaceDidBefore) {
    Rve other(support::public_packing().packing), alone(support::public_packing().packing);
    Workspace fresh;
    for (int k = 0; k < 10; ++k) shear(rve, 3), shear(other, 2);
    std::swap(fresh, work);
    shear(alone, 30);
    EXPECT_EQ(rve.stress(), alone.stress());
}

TEST_F(MixedRve, ShowsTheContactsOfItsStress) {
    shear(rve, 20);
    const Observables seen = observe(rve, {});
    EXPECT_GT(seen.contacts, 400);
    const Packing p = to_packing(rve.packing());
    const Mat2 s = observe(p, contact_forces(p, {}), {}).stress;
    EXPECT_LE((s - rve.packing().stress).norm(), 1e-4 * s.norm());
    EXPECT_NEAR(seen.coordination, observe(p, contact_forces(p, {}), {}).coordination, 1e-9);
}

TEST_F(MixedRve, FloatsAndComesBackUnderLoad) {
    const Mat2 open = (Mat2() << 1.001, 0, 0, 1).finished(), close = open.inverse();
    int opened = 0;
    while (!rve.floating() && opened < 60) drive(rve, open), ++opened;
    ASSERT_TRUE(rve.floating());
    EXPECT_TRUE(rve.stress().isZero(0));
    for (int k = 0; k < opened + 10; ++k) ASSERT_FALSE(failed(drive(rve, close).status));
    EXPECT_FALSE(rve.floating());
    EXPECT_GT(rve.stress().trace(), 2e3);
}

TEST_F(MixedRve, AKernelTakesUpWhatTheOtherLeft) {
    shear(rve, 5);
    const Mat2 mixed = rve.stress();
    options.kernel = RveKernel::double_precision;
    drive(rve, (Mat2() << 1 + 1e-9, 0, 0, 1).finished());
    EXPECT_LE((rve.stress() - mixed).norm(), 1e-2 * mixed.norm());
    EXPECT_FALSE(rve.packing().mixed.has_value());
}

// What moves leave below a unit of position is carried: three floats a grain more.
TEST_F(MixedRve, IsHardlyLargerAtRestThanInDouble) {
    shear(rve, 2);
    Rve other(support::public_packing().packing);
    options.kernel = RveKernel::double_precision;
    shear(other, 2);
    EXPECT_LE(static_cast<double>(rve.packing().bytes()),
              1.15 * static_cast<double>(other.packing().bytes()));
}

}  // namespace
}  // namespace sandgraph::dem

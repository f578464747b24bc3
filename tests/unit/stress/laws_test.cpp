#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

#include "base/random.hpp"
#include "stress/elastic.hpp"
#include "stress/increment.hpp"
#include "stress/mohr_coulomb.hpp"

namespace sandgraph::stress {
namespace {

constexpr double young = 20e6, poisson = 0.3;
const Stress rest{-30e3, -50e3, 4e3};

std::unique_ptr<Law> make(const std::string& name, std::size_t points) {
    const std::vector<Stress> initial(points, rest);
    if (name == "Elastic") return std::make_unique<Elastic>(ElasticConstants{young, poisson}, initial);
    return std::make_unique<MohrCoulomb>(MohrCoulombConstants{young, poisson, 0.55, 0.1, 1e3}, initial,
                                         std::vector<double>(points, -35e3));
}

Mat2 rotation(double angle) {
    return (Mat2() << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle)).finished();
}

Mat2 random_increment(Random& random, double size) {
    Mat2 F = Mat2::Identity();
    for (int k = 0; k < 4; ++k) F(k / 2, k % 2) += size * random.uniform(-1, 1);
    return F;
}

class AnyLaw : public testing::TestWithParam<const char*> {
  protected:
    static constexpr std::size_t count = 40;
    std::vector<std::int32_t> all = std::vector<std::int32_t>(count);
    std::vector<Mat2> F = std::vector<Mat2>(count, Mat2::Identity());
    std::vector<Stress> stress = std::vector<Stress>(count);
    void SetUp() override { std::iota(all.begin(), all.end(), 0); }
};

TEST_P(AnyLaw, StartsFromTheGivenStress) {
    make(GetParam(), count)->initialise({all, F, stress, 0});
    for (const Stress& s : stress) EXPECT_EQ(s, rest);
}

// The same path seen by an observer who turns along with it by an angle of his own at every step.
TEST_P(AnyLaw, IsObjective) {
    const auto fixed = make(GetParam(), count), turning = make(GetParam(), count);
    std::vector<Stress> turned(count);
    fixed->initialise({all, F, stress, 0});
    turning->initialise({all, F, turned, 0});
    std::vector<Mat2> seen = F;
    Random random(5);
    double angle = 0;
    for (int step = 0; step < 50; ++step) {
        const double next = angle + random.uniform(-1, 1);
        for (std::size_t p = 0; p < count; ++p) {
            F[p] = random_increment(random, 1e-3);
            seen[p] = rotation(next) * F[p] * rotation(angle).transpose();
        }
        angle = next;
        fixed->update({all, F, stress, 1});
        turning->update({all, seen, turned, 1});
    }
    for (std::size_t p = 0; p < count; ++p) {
        const Stress expected = rotate(stress[p], std::cos(angle), std::sin(angle));
        EXPECT_NEAR(turned[p].xx, expected.xx, 1e-6);
        EXPECT_NEAR(turned[p].yy, expected.yy, 1e-6);
        EXPECT_NEAR(turned[p].xy, expected.xy, 1e-6);
    }
}

TEST_P(AnyLaw, GivesTheSameBitsForAnySplitIntoBatches) {
    const auto whole = make(GetParam(), count), split = make(GetParam(), count);
    std::vector<Stress> parts(count);
    whole->initialise({all, F, stress, 0});
    split->initialise({all, F, parts, 0});
    Random random(6);
    for (int step = 0; step < 20; ++step) {
        for (Mat2& f : F) f = random_increment(random, 1e-3);
        whole->update({all, F, stress, 1});
        for (std::size_t from = count; from > 0;) {
            const std::size_t size = std::min<std::size_t>(from, 7);
            from -= size;
            split->update({std::span(all).subspan(from, size), F, parts, 1});
        }
    }
    EXPECT_EQ(stress, parts);
}

INSTANTIATE_TEST_SUITE_P(ClosedForm, AnyLaw, testing::Values("Elastic", "MohrCoulomb"));

TEST(Elastic, AnswersConfinedCompressionWithThePWaveModulus) {
    Elastic law({young, poisson}, {Stress{}});
    const std::vector<std::int32_t> one{0};
    std::vector<Mat2> F{(Mat2() << 1, 0, 0, 1 - 1e-6).finished()};
    std::vector<Stress> s(1);
    law.update({one, F, s, 1});
    const double M = young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson));
    EXPECT_NEAR(s[0].yy, -M * 1e-6, 1e-5 * M * 1e-6);
    EXPECT_NEAR(s[0].xx, -M * 1e-6 * poisson / (1 - poisson), 1e-5 * M * 1e-6);
    EXPECT_NEAR(law.p_wave_modulus(), M, 1e-6);
}

TEST(Elastic, AnswersShearWithTheShearModulus) {
    Elastic law({young, poisson}, {Stress{}});
    const std::vector<std::int32_t> one{0};
    std::vector<Mat2> F{(Mat2() << 1, 1e-6, 0, 1).finished()};
    std::vector<Stress> s(1);
    law.update({one, F, s, 1});
    EXPECT_NEAR(s[0].xy, young / (2 * (1 + poisson)) * 1e-6, 1e-4);
}

}  // namespace
}  // namespace sandgraph::stress

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cstdlib>
#include <set>

#include "dem/packing/compact_packing.hpp"
#include "packings/samples.hpp"
#include "scene/read_scene.hpp"
#include "simulation/scene_spec.hpp"
#include "support/paths.hpp"
#include "surrogate/load_surrogate.hpp"
#include "tests/support/memory_archive.hpp"
#include "tests/unit/simulation/grain_scene.hpp"

// Ground whose points are dealt from three base packings.
namespace sandgraph::simulation {
namespace {

const std::string kScene = test::grain_scene(2.5, R"([grains]
count = 40
samples = 3
)");
constexpr std::size_t kRows = 10, kSamples = 3;

scene::Scene scene(const std::vector<std::string>& set = {}) {
    return scene::parse_scene(kScene, "s.toml", set);
}

const packings::PreparedGround& ground() {
    static const packings::PreparedGround prepared = [] {
        packings::PreparedGround made = test::freshly_prepared(scene());
        made.surrogate =
            surrogate::load_surrogate(sandgraph::test::source_file("/configs/models/table1.surrogate.h5"));
        return made;
    }();
    return prepared;
}

std::vector<double> bits(const Simulation& pull) {
    std::vector<double> out;
    const mpm::Points& g = pull.state().points;
    for (std::size_t p = 0; p < g.size(); ++p)
        out.insert(out.end(), {g.x[p], g.y[p], g.stress[p].xx, g.stress[p].yy, g.stress[p].xy});
    return out;
}

std::vector<double> after(Simulation& pull, int steps, std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    for (int k = 0; k < steps; ++k) pull.step();
    return bits(pull);
}

TEST(SampledGround, HasPackingsOfEverySampleInEveryRow) {
    ASSERT_EQ(ground().packings.size(), kRows * kSamples);
    std::set<std::int64_t> different;
    for (const graph::RowPacking& one : ground().packings) different.insert(dem::content_hash(*one.packing));
    EXPECT_EQ(different.size(), kRows * kSamples);
    for (std::size_t k = 0; k < ground().packings.size(); ++k) {
        const double p = ground().row_pressure[k / kSamples];
        EXPECT_NEAR(ground().traits[k].pressure, p, 0.002 * p) << k;
    }
}

TEST(SampledGround, KnowsTheFrictionOfEachAndTheMeanOfAll) {
    double mean = 0;
    for (std::size_t k = 0; k < kSamples; ++k) {
        const double own = ground().traits[k].peak_friction;
        EXPECT_EQ(ground().traits[kSamples + k].peak_friction, own) << "of the base packing, in every row";
        mean += std::asin(own) / kSamples;
    }
    EXPECT_NE(ground().traits[0].peak_friction, ground().traits[1].peak_friction);
    EXPECT_NEAR(ground().friction_angle, mean, 1e-12);
    EXPECT_EQ(ground().friction.packings, 6);
}

// One DEM step for all, that of the smallest grain and the mean of all.
TEST(SampledGround, TakesTheGrainsOfAllSamplesIntoAccount) {
    const std::vector<double> radii = ground().radii();
    EXPECT_EQ(std::set(radii.begin(), radii.end()).size(), 40 * kSamples);
}

TEST(SampledGround, PointsStartFromThePackingTheyWereDealt) {
    const auto pull = simulation_of(scene(), ground());
    const mpm::Points& g = pull->state().points;
    const auto dealt = packings::deal(g.row, scene().ground.grains);
    for (std::size_t p = 0; p < g.size(); ++p) {
        const auto& packing = ground().packings[static_cast<std::size_t>(dealt[p])].packing;
        const dem::CompactPacking& first = pull->state().law->observe(p).packing->packing();
        EXPECT_EQ(first.grains, packing->grains);
        EXPECT_EQ(first.H, packing->H);
        EXPECT_EQ(first.stress, packing->stress);
        EXPECT_EQ(g.stress[p].yy, -packing->stress(1, 1));
    }
}

class SampledMode : public testing::TestWithParam<std::vector<std::string>> {};

TEST_P(SampledMode, GivesTheSameBitsForAnyThreadsAndAfterARestart) {
    const scene::Scene s = scene(GetParam());
    const auto one = simulation_of(s, ground()), two = simulation_of(s, ground()),
               resumed = simulation_of(s, ground());
    after(*two, 300, 2);
    support::MemoryArchive memory;
    two->archive(memory);
    memory.read_from_now_on();
    resumed->archive(memory);
    const std::vector<double> whole = after(*one, 600, 1);
    EXPECT_EQ(after(*two, 300, 2), whole);
    EXPECT_EQ(after(*resumed, 300, 1), whole);
    EXPECT_GT(one->state().law->grain_use().dem_steps, 0);
}

using Settings = std::vector<std::string>;
INSTANTIATE_TEST_SUITE_P(Modes, SampledMode,
                         testing::Values(Settings{},
                                         Settings{"mode=screening", "gate.strain=1e-5", "audit.share=0.1"}));

}  // namespace
}  // namespace sandgraph::simulation

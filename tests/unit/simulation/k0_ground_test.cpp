#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "base/error.hpp"
#include "scene/read_scene.hpp"
#include "simulation/scene_spec.hpp"
#include "tests/unit/simulation/grain_scene.hpp"

// Ground of grains that are consolidated with less horizontal than vertical stress.
namespace sandgraph::simulation {
namespace {

constexpr double kK0 = 0.5;
const std::string kScene = test::grain_scene(2.5, R"([ground]
k0 = 0.5
[grains]
count = 60
)");

scene::Scene scene(const std::vector<std::string>& set = {}) {
    return scene::parse_scene(kScene, "s.toml", set);
}

const packings::PreparedGround& ground() {
    static const packings::PreparedGround prepared = test::freshly_prepared(scene());
    return prepared;
}

TEST(K0Ground, EveryRowIsConsolidatedToIt) {
    for (std::size_t row = 0; row < ground().packings.size(); ++row) {
        const Mat2& stress = ground().packings[row].packing->stress;
        const double vertical = ground().row_pressure[row];
        EXPECT_NEAR(stress(1, 1), vertical, 2e-3 * vertical) << row;
        EXPECT_NEAR(stress(0, 0), kK0 * vertical, 0.02 * kK0 * vertical) << row;
        EXPECT_NEAR(ground().traits[row].pressure, 0.5 * (1 + kK0) * vertical, 2e-3 * vertical) << row;
    }
}

// With a plate and without: what moves is what consolidation left, a thousandth of the stress.
TEST(K0Ground, StaysAtRest) {
    for (const char* plate : {"anchor.present=true", "anchor.present=false"}) {
        const auto simulation = simulation_of(scene({plate}), ground());
        const mpm::Points start = simulation->state().points;
        for (int k = 0; k < 400; ++k)
            simulation->anchored() ? simulation->step(Vec2(0, 0)) : simulation->step();
        const mpm::Points& now = simulation->state().points;
        for (std::size_t p = 0; p < now.size(); ++p) {
            const double vertical = -start.stress[p].yy;
            EXPECT_LT(std::hypot(now.x[p] - start.x[p], now.y[p] - start.y[p]), 2e-6) << plate;
            EXPECT_NEAR(-now.stress[p].yy, vertical, 0.01 * vertical + 10) << plate;
            EXPECT_NEAR(-now.stress[p].xx, kK0 * vertical, 0.01 * vertical + 10) << plate;
        }
    }
}

TEST(K0Ground, ThatNoPackingHoldsIsRefusedInOneLine) {
    try {
        packings::prepare_ground(scene({"ground.k0=0.2"}));
        ADD_FAILURE() << "prepared";
    } catch (const InputError& error) {
        const std::string what = error.what();
        EXPECT_NE(what.find("ground.k0 = 0.2"), std::string::npos) << what;
        EXPECT_NE(what.find("peak friction"), std::string::npos) << what;
        EXPECT_EQ(what.find('\n'), std::string::npos) << what;
    }
}

}  // namespace
}  // namespace sandgraph::simulation

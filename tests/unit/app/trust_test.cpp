#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/sand_scene.hpp"
#include "tests/support/subprocess.hpp"

namespace sandgraph::app {
namespace {

nlohmann::json summary_of(const Shell& shell, const std::string& folder) {
    return nlohmann::json::parse(shell.read(folder + "/summary.json"));
}

TEST(Trust, NoBreakoutIsClaimedOfAPlateThatIsTooFast) {
    const Shell shell("too_fast");
    shell.write("scene.toml", support::sand_scene());
    const auto run = shell.run("run scene.toml -o out --set 'anchor.pull_rate=3 m/s'");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_NE(run.err.find("warning: anchor.pull_rate = 3 m/s is fast"), std::string::npos) << run.err;
    EXPECT_NE(run.out.find("no breakout is claimed"), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("warning: anchor.pull_rate = 3 m/s is fast"), std::string::npos) << run.out;
    const auto summary = summary_of(shell, "out");
    EXPECT_EQ(summary["breakout"], false);
    EXPECT_TRUE(summary["n_gamma"].is_null());
    EXPECT_GT(summary["peak_load_N_per_m"].get<double>(), 0);
    EXPECT_GE(summary["warnings"].size(), 2u);
}

TEST(Trust, ABreakoutIsClaimedOfASlowPlateAndItsFormulaIsForItsThickness) {
    const Shell shell("slow");
    shell.write("scene.toml", support::sand_scene());
    const auto run = shell.run("run scene.toml -o out");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const auto summary = summary_of(shell, "out");
    EXPECT_EQ(summary["breakout"], true);
    EXPECT_GT(summary["n_gamma"].get<double>(), 1.5);
    // 1 + 0.95 tan(30 deg) 2.125^2 / 2
    EXPECT_NEAR(summary["n_gamma_meyerhof_adams_thick"].get<double>(), 2.2384, 1e-4);
    EXPECT_EQ(summary["friction_packings"], 0);
    EXPECT_LE(summary["warnings"].size(), 2u);  // of the cells, and of a drag of 2.4 %
    EXPECT_NE(run.out.find("8 cells a plate width"), std::string::npos) << run.out;
}

// Damping of 0.9 carries a tenth of the load and more; the default carries next to nothing.
TEST(Trust, TheLoadThatDampingCarriesIsToldAndForbidsABreakout) {
    const Shell shell("damped");
    shell.write("scene.toml", support::sand_scene({.pull_to = 0.02}));
    const auto run = shell.run(
        "run scene.toml -o out --set mpm.damping=0.9 --set mpm.mass_scaling=10 --set 'anchor.pull_rate=0.05 "
        "m/s'");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_NE(run.out.find("warning: damping, PIC and inertia carry"), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("lower mpm.damping"), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("no breakout is claimed"), std::string::npos) << run.out;
    const auto dragged = summary_of(shell, "out");
    EXPECT_GT(dragged["drag_share"].get<double>(), 0.1);
    EXPECT_NEAR(dragged["drag_share"].get<double>(),
                dragged["damping_share"].get<double>() + dragged["pic_share"].get<double>() +
                    dragged["inertia_share"].get<double>(),
                1e-12);
    EXPECT_EQ(dragged["breakout"], false);
    EXPECT_TRUE(dragged["n_gamma"].is_null());
    ASSERT_EQ(shell.run("run scene.toml -o usual").exit_code, 0);
    const auto usual = summary_of(shell, "usual");
    EXPECT_LT(usual["drag_share"].get<double>(), 0.03);
    EXPECT_GT(usual["drag_share"].get<double>(), 0);
}

TEST(Trust, OfARunThatStillRisesThereIsNoBreakoutFactor) {
    const Shell shell("rising");
    shell.write("scene.toml", support::sand_scene());
    ASSERT_EQ(shell.run("run scene.toml -o out --until 0.003").exit_code, 0);
    EXPECT_EQ(summary_of(shell, "out")["breakout"], false);
    EXPECT_TRUE(summary_of(shell, "out")["n_gamma"].is_null());
}

}  // namespace
}  // namespace sandgraph::app

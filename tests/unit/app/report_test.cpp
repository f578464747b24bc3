#include <gtest/gtest.h>

#include "tests/support/subprocess.hpp"

namespace sandgraph::app {
namespace {

// A continuum, so that the pull takes a second.
constexpr const char* kScene = R"(
title = "Plate & <sand>"
[domain]
width = "2 m"
depth = "4 m"
cell = "0.25 m"
[anchor]
embedment_ratio = 1
thickness = "0.25 m"
pull_to = 0.02
[ground]
law = "elastic"
[output]
frames = [0, 0.02]
load_every = 0.0005
)";

TEST(Report, SetsAllRunsOfAFolderSideBySideInOnePage) {
    const Shell shell("report");
    shell.write("scene.toml", kScene);
    ASSERT_EQ(shell.run("run scene.toml -o runs/a").exit_code, 0);
    ASSERT_EQ(shell.run("run scene.toml -o runs/b --set anchor.embedment_ratio=2").exit_code, 0);
    const auto outcome = shell.run("report runs -o page");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const std::string html = shell.read("page/index.html");
    for (const char* text :
         {"runs/a", "runs/b", "Plate &amp; &lt;sand&gt;", "N_gamma", "embedment_ratio",
          "data:image/png;base64,iVBOR", "<a href=\"#runs/a\">", "<h2 id=\"runs/a\">", "γ [kN/m3]", "φ [deg]",
          "breakout load [kN/m]", "unit weight γ [kN/m3]</td><td data-label=\"\">21.6<"})
        EXPECT_NE(html.find(text), std::string::npos) << text;
    EXPECT_EQ(html.find("no picture"), std::string::npos);
    // Elastic ground never breaks out, and no formula is known for it.
    EXPECT_NE(html.find("(no breakout)"), std::string::npos);
    EXPECT_EQ(html.find("nan %"), std::string::npos);
    EXPECT_FALSE(shell.exists("page/pictures/breakout.png"));
    EXPECT_TRUE(shell.exists("page/pictures/00_a/load.png"));
}

// One run without a title of its own.
void make_run(const Shell& shell, const std::string& folder) {
    const std::string scene = kScene;
    shell.write("scene.toml", scene.substr(scene.find("[domain]")));
    ASSERT_EQ(shell.run("run scene.toml -o " + folder).exit_code, 0);
}

TEST(Report, FolderIsOneRunHoweverItIsWritten) {
    const Shell shell("slash");
    make_run(shell, "h2.5");
    EXPECT_NE(shell.run("measure h2.5/").out.find("\nh2.5,"), std::string::npos);
    ASSERT_EQ(shell.run("report h2.5/ h2.5 ./h2.5 -o page").exit_code, 0);
    const std::string html = shell.read("page/index.html");
    EXPECT_NE(html.find(">1 run;"), std::string::npos);
    EXPECT_NE(html.find("<h2 id=\"h2.5\">h2.5</h2>"), std::string::npos);
    EXPECT_TRUE(shell.exists("page/pictures/00_h2.5/load.png"));
}

// Also of a finished run whose scene asks for them.
TEST(Report, LeavesVectorPicturesBesideTheOthersIfTheSceneAsksForThem) {
    const Shell shell("formats");
    shell.write("scene.toml", kScene);
    const auto run = shell.run("run scene.toml -o a --set output.picture_format=svg");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    ASSERT_EQ(shell.run("report a -o page").exit_code, 0);
    for (const char* name : {"load.png", "load.svg", "strain_0020.png", "strain_0020.svg"})
        EXPECT_TRUE(shell.exists(std::string("page/pictures/00_a/") + name)) << name;
    EXPECT_EQ(shell.read("page/index.html").find("no picture"), std::string::npos);
}

TEST(Report, ShowsNoPictureOfAnOlderReport) {
    const Shell shell("older");
    make_run(shell, "a");
    const std::string pictures = "page/pictures/00_a/";
    std::filesystem::create_directories(shell.path(pictures));
    for (const char* name : {"strain_0500.png", "strain_0500.svg", "mine.png"})
        shell.write(pictures + name, "older");
    ASSERT_EQ(shell.run("report a -o page").exit_code, 0);
    EXPECT_EQ(shell.read("page/index.html").find("d/B = 0.5"), std::string::npos);
    EXPECT_FALSE(shell.exists(pictures + "strain_0500.png"));
    EXPECT_FALSE(shell.exists(pictures + "strain_0500.svg"));
    EXPECT_TRUE(shell.exists(pictures + "strain_0020.png"));
    EXPECT_TRUE(shell.exists(pictures + "mine.png"));
}

TEST(Report, RefusesFoldersWithoutARun) {
    const Shell shell("no_report");
    for (const char* folder : {".", "nowhere"}) {
        const auto outcome = shell.run(std::string("report ") + folder + " -o page");
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_FALSE(shell.exists("page"));
    }
}

}  // namespace
}  // namespace sandgraph::app

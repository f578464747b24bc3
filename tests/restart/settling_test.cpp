#include <cmath>

#include "io/summary.hpp"
#include "tests/restart/interrupted_run.hpp"

namespace sandgraph::restart {
namespace {

// Ground alone: no plate, so that time is what outputs and the end go by.
constexpr const char* kSettling = R"(
[domain]
width = "1 m"
depth = "1.5 m"
cell = "0.25 m"
[anchor]
present = false
[mpm]
end_time = "0.2 s"
[ground]
surcharge = "5 kPa"
[grains]
count = 60
[output]
load_every = 0.01
frames = [0, 0.05, 0.1, 0.2]
history = true
history_points = 12
checkpoint_every = "0.01 s"
[[region]]
name = "below"
x = ["0 m", "1 m"]
y = ["0 m", "0.5 m"]
)";

class SettlingGround : public InterruptedRun {
  protected:
    void SetUp() override {
        InterruptedRun::SetUp();
        std::ofstream(folder_ / "scene.toml") << kSettling;
    }
};

TEST_F(SettlingGround, RunsToItsEndTimeWithEveryOutputButLoads) {
    ASSERT_EQ(run("whole"), 0);
    const std::string load = text_of(out("whole") / "load.csv"),
                      regions = text_of(out("whole") / "regions.csv");
    EXPECT_EQ(std::count(load.begin(), load.end(), '\n'), 1);
    EXPECT_EQ(std::count(regions.begin(), regions.end(), '\n'), 1 + 21);
    const io::Summary summary = io::read_summary(out("whole") / "summary.json");
    EXPECT_EQ(summary.points, 24);
    EXPECT_GT(summary.steps, 100);
    EXPECT_TRUE(std::isnan(summary.breakout_load) && std::isnan(summary.n_gamma));
    const io::Frame last = io::read_run_frame(out("whole") / "run.h5", 3);
    EXPECT_NEAR(last.time, 0.2, 2e-3);
    EXPECT_TRUE(std::isnan(last.plate_x));
    EXPECT_NE(text_of(out("whole") / "fields.xdmf").find("frame 0003"), std::string::npos);
    EXPECT_FALSE(fs::exists(out("whole") / "checkpoint.h5"));
}

TEST_F(SettlingGround, GoesOnToTheSameBits) {
    ASSERT_EQ(run("whole"), 0);
    ASSERT_EQ(run("part", {"--until", "0.12", "--threads", "1"}), 0);
    EXPECT_TRUE(fs::exists(out("part") / "checkpoint.h5"));
    ASSERT_EQ(run("part", {"--resume"}), 0);
    expect_same_ground("whole", "part");
    const auto whole = io::read_history(out("whole") / "history.h5"),
               part = io::read_history(out("part") / "history.h5");
    ASSERT_EQ(whole.begin, part.begin);
    for (std::size_t k = 0; k < whole.rows.size(); ++k) ASSERT_EQ(whole.rows[k].stress, part.rows[k].stress);
}

// Later ends are the same run gone on.
TEST_F(SettlingGround, GoesOnPastItsEndTimeWhenAsked) {
    ASSERT_EQ(run("part", {"--until", "0.1"}), 0);
    ASSERT_EQ(run("part", {"--resume", "--set", "mpm.end_time=0.3 s"}), 0);
    EXPECT_GT(io::read_run(out("part") / "run.h5").regions.front().rows.back().time, 0.29);
}

TEST_F(SettlingGround, RefusesAPlaceInPlateWidths) {
    EXPECT_EQ(run("nowhere", {"--set", "region=[{name=\"a\", at=[0, 1]}]"}), 2);
    EXPECT_FALSE(fs::exists(out("nowhere")));
}

}  // namespace
}  // namespace sandgraph::restart

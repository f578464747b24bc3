#include <gtest/gtest.h>

#include <sstream>
#include <vector>

#include "tests/support/subprocess.hpp"

namespace sandgraph::app {
namespace {

constexpr const char* kScene = R"(
[domain]
width = "2 m"
depth = "3 m"
cell = "0.25 m"
[anchor]
embedment_ratio = 1
thickness = "0.25 m"
pull_to = 0.01
pull_rate = "0.05 m/s"
ramp = 0.001
[ground]
law = "elastic"
[continuum]
young = "10 MPa"
)";

struct Row {
    double d, load;
};

std::vector<Row> rows(const Shell& shell, const std::string& folder) {
    std::istringstream csv(shell.read(folder + "/load.csv"));
    std::string line;
    std::getline(csv, line);
    std::vector<Row> all;
    while (std::getline(csv, line)) {
        std::istringstream cells(line);
        char comma;
        cells >> all.emplace_back().d >> comma >> all.back().load;
    }
    return all;
}

double at(const std::vector<Row>& curve, double d) {
    std::size_t k = 1;
    while (k + 1 < curve.size() && curve[k].d < d) ++k;
    const Row &a = curve[k - 1], &b = curve[k];
    return b.d > a.d ? a.load + (b.load - a.load) * (d - a.d) / (b.d - a.d) : a.load;
}

// A row is a mean over steps; it stands at their mean d/B, not at the last one's, or coarse rows would lag.
TEST(LoadCurve, CoarseRowsLieOnTheFineCurve) {
    const Shell shell("load_curve");
    shell.write("scene.toml", kScene);
    ASSERT_EQ(shell.run("run scene.toml -o fine --set output.load_every=0.00005").exit_code, 0);
    ASSERT_EQ(shell.run("run scene.toml -o coarse --set output.load_every=0.002").exit_code, 0);
    const auto fine = rows(shell, "fine"), coarse = rows(shell, "coarse");
    ASSERT_GT(fine.size(), 100u);
    ASSERT_GE(coarse.size(), 5u);
    const double largest = fine.back().load;
    // The first row also means over the rest before the pull and the ramp, where the curve is bent.
    for (std::size_t k = 2; k < coarse.size(); ++k)
        EXPECT_NEAR(coarse[k].load, at(fine, coarse[k].d), 0.01 * largest) << coarse[k].d;
}

}  // namespace
}  // namespace sandgraph::app

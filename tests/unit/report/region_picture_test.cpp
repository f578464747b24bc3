#include "report/region_picture.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "base/error.hpp"
#include "report/packing_picture.hpp"

namespace sandgraph::report {
namespace {

namespace fs = std::filesystem;

class CrossScalePictures : public testing::Test {
  protected:
    CrossScalePictures() { fs::create_directories(folder_); }
    ~CrossScalePictures() override { fs::remove_all(folder_); }
    fs::path write(const std::string& text) const {
        std::ofstream(folder_ / "critical.csv") << text;
        return folder_ / "critical.csv";
    }
    fs::path folder_ = fs::temp_directory_path() / ("sandgraph_regions_" + std::to_string(::getpid()));
};

io::RegionSeries region(const std::string& name) {
    io::RegionSeries series{name, 3, {}};
    for (int k = 0; k < 20; ++k) {
        io::RegionRow row;  // no packings: F_a unknown
        const double d = 0.01 * k;
        row.d_over_B = d, row.p = {1e4 + 1e5 * d, 9e3, 2e4}, row.q = {5e4 * d, 0, 6e4 * d};
        row.K = {1 + d, 1, 100}, row.porosity = {0.16 + 0.1 * d, 0.16, 0.18}, row.strain = {d, 0, 2 * d};
        row.rotation = {-d, -2 * d, 0};
        series.rows.push_back(row);
    }
    return series;
}

TEST_F(CrossScalePictures, AreDrawnOfRegionsThatKnowTheirPackingsOrNot) {
    const RegionPicture picture{"scene with 'quotes'", {region("A"), region("B")}};
    EXPECT_TRUE(draw_region_picture(picture, folder_ / "regions.png").drawn);
    const Picture paths =
        draw_stress_path_picture(picture, CriticalLines{0.36, 0.254, 0.004}, folder_ / "p.png");
    EXPECT_TRUE(paths.drawn) << paths.message;
    EXPECT_TRUE(draw_stress_path_picture(picture, std::nullopt, folder_ / "p.png").drawn);
}

TEST_F(CrossScalePictures, DrawPackingsWithAndWithoutContacts) {
    PackingPicture picture{"three grains", {}, {}, {{Mat2::Identity() * 0.03, 0.1}}};
    picture.packing.H = Mat2::Identity() * 0.03;
    picture.packing.x = {0.005, 0.0149, 0.02}, picture.packing.y = {0.01, 0.01, 0.02},
    picture.packing.r = {5e-3, 5e-3, 4e-3};
    const Picture touching = draw_packing_picture(picture, folder_ / "a.png");
    EXPECT_TRUE(touching.drawn) << touching.message;
    picture.packing.r = {1e-3, 1e-3, 1e-3};
    EXPECT_TRUE(draw_packing_picture(picture, folder_ / "b.png").drawn);
}

TEST_F(CrossScalePictures, CallThePackingsFirstCellThatBeforeThePullOnlyIfItIs) {
    PackingPicture picture{"empty", {}, {}, {{Mat2::Identity() * 0.03, 0}}};
    picture.packing.H = Mat2::Identity() * 0.03;
    EXPECT_NE(packing_plot(picture).script.find("'before the pull'"), std::string::npos);
    picture.first_cell->d_over_B = 0.05;
    const std::string later = packing_plot(picture).script;
    EXPECT_EQ(later.find("before the pull"), std::string::npos);
    EXPECT_NE(later.find("'at d/B = 0.05'"), std::string::npos);
}

// e = 0.27 - 0.01 p / 100 kPa, two densities with opposite scatter.
TEST_F(CrossScalePictures, TakeTheCriticalLinesFromTheTestsByLeastSquares) {
    std::string text = "density,seed,pressure,q_over_p,porosity,void_ratio,anisotropy,coordination\n";
    for (const double p : {2e3, 20e3, 200e3})
        for (const double side : {-1, 1})
            text += "dense,1," + std::to_string(p) + "," + std::to_string(0.36 + 0.01 * side) + ",0.2," +
                    std::to_string(0.27 - 0.01 * p / 100e3 + 0.002 * side) + ",0.3,3\n";
    const CriticalLines lines = read_critical_lines(write(text));
    EXPECT_NEAR(lines.stress_ratio, 0.36, 1e-9);
    EXPECT_NEAR(lines.e_0, 0.27, 1e-6);
    EXPECT_NEAR(lines.slope, 0.01, 1e-6);
}

TEST_F(CrossScalePictures, RefuseAnotherTable) {
    EXPECT_THROW(read_critical_lines(write("a,b\n1,2\n")), InputError);
    const std::string head = "density,seed,pressure,q_over_p,porosity,void_ratio,anisotropy\n";
    EXPECT_THROW(read_critical_lines(write(head + "dense,1,1e4,0.36,0.2,0.25,0.3\n")), InputError);
    EXPECT_THROW(read_critical_lines(write(head + "dense,1,what\n")), InputError);
}

}  // namespace
}  // namespace sandgraph::report

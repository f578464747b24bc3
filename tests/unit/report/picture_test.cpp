#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "report/colour_scale.hpp"
#include "report/field_picture.hpp"
#include "report/load_picture.hpp"
#include "tests/unit/io/scratch.hpp"
#include "tests/unit/report/synthetic.hpp"

namespace sandgraph::report {
namespace {

using test::Scratch;

std::size_t lines(const std::string& text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

// Width and height from the PNG header, {0, 0} if it is none.
std::pair<int, int> png_size(const std::filesystem::path& path) {
    const std::string bytes = test::contents(path);
    if (bytes.size() < 24 || bytes.substr(1, 3) != "PNG") return {0, 0};
    const auto number = [&](std::size_t at) {
        int n = 0;
        for (std::size_t k = at; k < at + 4; ++k) n = n * 256 + static_cast<unsigned char>(bytes[k]);
        return n;
    };
    return {number(16), number(20)};
}

// Folders of pictures hold pictures only.
std::size_t entries(const std::filesystem::path& folder) {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

LoadPicture two_runs() {
    LoadPicture picture{"H/B = 3, it's {dense}_1 & \"loose\"", {}, {{"Meyerhof & Adams (1968)", 2.66}}};
    for (const double peak : {2.95, 2.1}) {
        LoadCurve c{peak > 2.5 ? "dense" : "loose", {}, {}, 66e3, {}};
        for (double d = 0; d < 0.4; d += 0.001) {
            c.d_over_B.push_back(d);
            c.load.push_back(66e3 *
                             (peak * (1 - std::exp(-d / 0.006)) - (peak - 2) * (1 - std::exp(-d / 0.08))));
        }
        c.breakout = results::breakout(c.d_over_B, c.load);
        picture.curves.push_back(c);
    }
    return picture;
}

results::GroundView view() {
    results::GroundView v;
    v.title = "synthetic wedge";
    v.mirror = true;
    return v;
}

TEST(LoadPicture, DrawsOverlaidRunsWhateverTheTitleHolds) {
    const Scratch folder;
    const Picture picture = draw_load_picture(two_runs(), folder / "load.png");
    ASSERT_TRUE(picture.drawn) << picture.message;
    EXPECT_EQ(picture.message, "");
    EXPECT_EQ(png_size(folder / "load.png"), std::pair(1100, 750));
    EXPECT_EQ(entries(folder.path()), 1u);
}

TEST(LoadPicture, RightAxisNeedsOneUnitLoad) {
    LoadPicture picture = two_runs();
    EXPECT_NE(load_plot(picture).script.find("kN/m"), std::string::npos);
    picture.curves[1].unit_load = 1;
    EXPECT_EQ(load_plot(picture).script.find("kN/m"), std::string::npos);
}

TEST(FieldPicture, DrawsEveryQuantity) {
    const Scratch folder;
    const io::Frame frame = test::lifted_wedge(0.3);
    for (const results::Quantity q : {results::Quantity::displacement, results::Quantity::equivalent_strain,
                                      results::Quantity::rotation, results::Quantity::porosity}) {
        const auto png = folder / (std::to_string(static_cast<int>(q)) + ".png");
        const Picture picture = draw_field_picture(frame, q, view(), png);
        ASSERT_TRUE(picture.drawn) << picture.message;
        EXPECT_EQ(picture.message, "");
        EXPECT_GT(png_size(png).second, 300);
    }
    EXPECT_EQ(entries(folder.path()), 4u);
}

TEST(FieldPicture, UnstrainedGroundIsDrawnToo) {
    const Scratch folder;
    for (const results::Quantity q :
         {results::Quantity::displacement, results::Quantity::rotation, results::Quantity::porosity}) {
        const Picture picture = draw_field_picture(test::lifted_wedge(0), q, view(), folder / "a.png");
        EXPECT_TRUE(picture.drawn) << picture.message;
    }
}

TEST(FieldPicture, MissingFieldIsAMessageAndNoThrow) {
    const Scratch folder;
    io::Frame frame = test::lifted_wedge(0.1);
    frame.fields.clear();
    const Picture picture = draw_field_picture(frame, results::Quantity::rotation, view(), folder / "a.png");
    EXPECT_FALSE(picture.drawn);
    EXPECT_NE(picture.message.find("no field 'F'"), std::string::npos) << picture.message;
}

TEST(FieldRows, MirrorImageTurnsTheOtherWay) {
    io::Frame frame = test::lifted_wedge(0.1, 0.1, 0.1);
    ASSERT_EQ(frame.x.size(), 1u);
    const results::PointValues rotation{"rotation", "deg", true, {5}};
    const std::string rows = square_rows(frame, rotation, view());
    EXPECT_NE(rows.find("0.05 "), std::string::npos);
    EXPECT_NE(rows.find("-0.05 "), std::string::npos);
    EXPECT_NE(rows.find(" -5\n"), std::string::npos) << rows;
    const results::PointValues strain{"strain", "-", false, {5}};
    EXPECT_EQ(square_rows(frame, strain, view()).find(" -5\n"), std::string::npos);
    const results::PointValues lost{"strain", "-", false, {std::nan("")}};
    EXPECT_EQ(square_rows(frame, lost, view()), "");
}

TEST(FieldRows, ArrowsAreSparseAndLeaveRestOut) {
    const io::Frame frame = test::lifted_wedge(0.3);
    const std::string arrows = arrow_rows(frame, view(), 0.3);
    EXPECT_GT(lines(arrows), 50u);
    EXPECT_LT(lines(arrows), 2 * frame.x.size() / 9 + 50);
    EXPECT_EQ(arrow_rows(test::lifted_wedge(0), view(), 0.3), "");
}

TEST(ColourRange, IsSymmetricForSignedAndStartsAtZeroForMagnitudes) {
    std::vector<double> values;
    for (int k = 0; k <= 1000; ++k) values.push_back(-10 + 0.05 * k);  // -10 .. 40
    const ColourRange sym = colour_range(values, true, false);
    EXPECT_EQ(sym.low, -sym.high);
    EXPECT_GE(sym.high, 39);
    const ColourRange positive = colour_range({0.2, 0.5, 0.9}, false, true);
    EXPECT_EQ(positive.low, 0);
    EXPECT_GE(positive.high, 0.9);
    EXPECT_FALSE(positive.clipped_high);
}

TEST(ColourRange, OneRunawayPointDoesNotBleachThePicture) {
    std::vector<double> values(1000, 0.5);
    values.push_back(1e6);
    values.push_back(std::nan(""));
    const ColourRange range = colour_range(values, false, true);
    EXPECT_LT(range.high, 1);
    EXPECT_TRUE(range.clipped_high);
}

TEST(Gnuplot, MissingProgramAndBrokenScriptAreMessages) {
    const Scratch folder;
    Plot plot;
    plot.script = "plot x\n";
    const Picture missing = draw(plot, folder / "a.png", "no-such-gnuplot");
    EXPECT_FALSE(missing.drawn);
    EXPECT_NE(missing.message.find("install gnuplot-nox"), std::string::npos) << missing.message;
    plot.script = "plot 'absent.txt' using 1:2\n";
    const Picture broken = draw(plot, folder / "a.png");
    EXPECT_FALSE(broken.drawn);
    EXPECT_NE(broken.message.find("absent.txt"), std::string::npos) << broken.message;
    EXPECT_EQ(broken.message.find('\n'), std::string::npos);
    const Picture nowhere = draw(plot, "/no/such/folder/a.png");
    EXPECT_FALSE(nowhere.drawn);
    EXPECT_EQ(entries(folder.path()), 0u);
}

TEST(Gnuplot, LiteralCannotBreakOutOfItsQuotes) {
    EXPECT_EQ(literal("it's"), "'it''s'");
    EXPECT_EQ(literal("a\nsystem(\"x\")"), "'a system(\"x\")'");
}

}  // namespace
}  // namespace sandgraph::report

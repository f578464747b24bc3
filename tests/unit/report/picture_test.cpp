#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

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

// The number behind `key` in the script.
double number_after(const std::string& script, const std::string& key) {
    const std::size_t at = script.find(key);
    EXPECT_NE(at, std::string::npos) << key << " not in\n" << script;
    return at == std::string::npos ? std::nan("") : std::strtod(script.c_str() + at + key.size(), nullptr);
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
    const Plot plot = load_plot(two_runs());
    EXPECT_EQ(png_size(folder / "load.png"), std::pair(2 * plot.width, 2 * plot.height));
    EXPECT_EQ(entries(folder.path()), 1u);
}

LoadPicture one_run() {
    LoadPicture picture = two_runs();
    picture.curves.resize(1);
    picture.curves[0].label = picture.title;
    return picture;
}

TEST(LoadPicture, KeyDoesNotRepeatTheTitle) {
    const std::string script = load_plot(one_run()).script;
    const std::string title = literal(one_run().title);
    EXPECT_EQ(script.find(title), script.rfind(title)) << script;
    EXPECT_NE(load_plot(two_runs()).script.find("title 'loose: 2."), std::string::npos);
}

TEST(LoadPicture, HasEveryPointOfEveryCurve) {
    LoadPicture picture = two_runs();
    while (picture.curves.size() < 9) picture.curves.push_back(picture.curves.front());
    for (const auto& [name, rows] : load_plot(picture).data)
        EXPECT_EQ(lines(rows), picture.curves.front().load.size()) << name;
}

// Labels stand where the axes reach: gnuplot leaves out what lies beyond.
TEST(LoadPicture, AxesHoldEveryLabelAndNegativeLoads) {
    LoadPicture picture = one_run();
    picture.references = {{"a formula", 9.5}};
    std::string script = load_plot(picture).script;
    EXPECT_GT(number_after(script.substr(script.find("set yrange [")), ":"), 9.5);
    EXPECT_NE(script.find("a formula: 9.50"), std::string::npos);
    EXPECT_EQ(number_after(script, "set yrange ["), 0);
    for (double& load : picture.curves[0].load) load -= 200e3;
    script = load_plot(picture).script;
    EXPECT_LT(number_after(script, "set yrange ["), -200.0 / 66);
}

TEST(LoadPicture, LabelsOfFormulasThatAgreeDoNotCoverEachOther) {
    LoadPicture picture = one_run();
    picture.references = {{"textbook", 2.60}, {"thick plate", 2.66}};
    const std::string script = load_plot(picture).script;
    EXPECT_NE(script.find("'thick plate: 2.66' at graph 0.98, first 2.66 right offset 0,0.8"),
              std::string::npos);
    EXPECT_NE(script.find("'textbook: 2.60' at graph 0.98, first 2.6 right offset 0,-0.8"),
              std::string::npos);
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
        const Picture picture =
            draw_field_picture(frame, q, view(), field_range(frame, q, view()), png, {".png"});
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
        const Picture picture =
            draw_field_picture(test::lifted_wedge(0), q, view(), {}, folder / "a.png", {".png"});
        EXPECT_TRUE(picture.drawn) << picture.message;
    }
}

TEST(FieldPicture, MissingFieldIsAMessageAndNoThrow) {
    const Scratch folder;
    io::Frame frame = test::lifted_wedge(0.1);
    frame.fields.clear();
    const Picture picture =
        draw_field_picture(frame, results::Quantity::rotation, view(), {}, folder / "a.png", {".png"});
    EXPECT_FALSE(picture.drawn);
    EXPECT_NE(picture.message.find("no field 'F'"), std::string::npos) << picture.message;
}

Plot wedge_plot(double lift, results::Quantity quantity, const ColourRange& range = {0, 0.4}) {
    return field_plot(test::lifted_wedge(lift), quantity, view(), range);
}

TEST(FieldPicture, HasTheColoursOfTheRunNotOfTheFrame) {
    for (const double lift : {0.0, 0.02, 0.3}) {
        const std::string script = wedge_plot(lift, results::Quantity::displacement).script;
        EXPECT_NE(script.find("set cbrange [0:0.4]"), std::string::npos) << script;
    }
}

// Of gnuplot an axis whose first end is the larger one runs downwards.
TEST(FieldPicture, DepthRunsDownwardsFromTheSurface) {
    const Plot plot = wedge_plot(0.3, results::Quantity::displacement);
    EXPECT_NE(plot.script.find("set ylabel 'depth below the surface [m]'"), std::string::npos);
    const double bottom = number_after(plot.script, "set yrange [");
    EXPECT_NEAR(bottom, 5, 0.3);
    const std::string range = plot.script.substr(plot.script.find("set yrange ["));
    const double top = number_after(range, ":");
    EXPECT_LT(top, -0.3 * 0.9);  // the heave, and air for its arrows
    EXPECT_GT(top, -1);
    // The plate lies 3 m deep and has risen by 0.3 m; the surface is at 0.
    const std::string plate = plot.script.substr(plot.script.find("rectangle from "));
    EXPECT_NEAR(number_after(plate, ","), 3.1 - 0.3, 1e-9);
    EXPECT_EQ(plot.data.at(1).second, "-6 0\n6 0\n");
}

TEST(FieldPicture, ArrowsPointUpTheDepthAxisAndHaveAScale) {
    const Plot plot = wedge_plot(0.3, results::Quantity::displacement);
    const ArrowScale scale = arrow_scale(test::lifted_wedge(0.3), view(), {0, 0.4});
    EXPECT_NE(plot.script.find(" m' at first"), std::string::npos);
    EXPECT_NE(plot.script.find("set arrow 1"), std::string::npos);
    ASSERT_EQ(plot.data.back().first, "arrows.txt");
    std::istringstream rows(plot.data.back().second);
    for (double x, depth, dx, up; rows >> x >> depth >> dx >> up;) {
        EXPECT_LT(up, 0);
        EXPECT_GE(-up, scale.length * scale.least * 0.999);
        EXPECT_LE(-up, scale.spacing * 1.001);
    }
    const double length = number_after(plot.script.substr(plot.script.find("set arrow 1")), " to first ") -
                          number_after(plot.script, "set arrow 1 from first ");
    EXPECT_NEAR(length, scale.shown * scale.length, 1e-9);
}

TEST(FieldPicture, PaintsNothingWhereNothingHasMoved) {
    const Plot plot = wedge_plot(0, results::Quantity::displacement);
    EXPECT_EQ(plot.script.find("arrow"), std::string::npos);
    // Zero is the pale end of the palette, of signed values its pale middle.
    EXPECT_NE(plot.script.find("defined (0 '#f3f3ee'"), std::string::npos);
    EXPECT_NE(palette(ValueKind::signed_value).find("4 '#f0f0f0'"), std::string::npos);
    EXPECT_EQ(wedge_plot(1e-9, results::Quantity::displacement).script.find("arrow"), std::string::npos);
}

TEST(FieldPicture, NamesFieldAndMomentHoweverLongTheSceneIsCalled) {
    results::GroundView named = view();
    named.title = std::string(200, 'w') + " end";
    const Plot plot = field_plot(test::lifted_wedge(0.1), results::Quantity::rotation, named, {-5, 5});
    EXPECT_NE(plot.script.find("'d/B = 0.1: rotation"), std::string::npos) << plot.script;
    for (const std::string& line : lines_of(named.title, plot.width - 20))
        EXPECT_LT(9.4 * static_cast<double>(line.size()), plot.width);
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
    const ColourRange range = field_range(frame, results::Quantity::displacement, view());
    const ArrowScale scale = arrow_scale(frame, view(), range);
    const std::string arrows = arrow_rows(frame, view(), scale);
    const double bins = 12 * 5 / (scale.spacing * scale.spacing);  // of ground, mirror image included
    EXPECT_GT(lines(arrows), 40u);
    EXPECT_LT(static_cast<double>(lines(arrows)), 0.7 * bins);  // most of the ground rests
    const ArrowScale none = arrow_scale(test::lifted_wedge(0), view(), range);
    EXPECT_EQ(none.shown, 0);
    EXPECT_EQ(arrow_rows(test::lifted_wedge(0), view(), none), "");
}

TEST(ColourRange, IsSymmetricForSignedAndStartsAtZeroForMagnitudes) {
    std::vector<double> values;
    for (int k = 0; k <= 1000; ++k) values.push_back(-10 + 0.05 * k);  // -10 .. 40
    const ColourRange sym = colour_range(values, ValueKind::signed_value, 0.1);
    EXPECT_EQ(sym.low, -sym.high);
    EXPECT_GE(sym.high, 39);
    const ColourRange positive = colour_range({0.2, 0.5, 0.9}, ValueKind::magnitude, 0.1);
    EXPECT_EQ(positive.low, 0);
    EXPECT_GE(positive.high, 0.9);
    EXPECT_EQ(beyond(positive, {0.2, 0.5, 0.9}), "");
}

TEST(ColourRange, OneRunawayPointDoesNotBleachThePicture) {
    std::vector<double> values(1000, 0.5);
    values.push_back(1e6);
    values.push_back(std::nan(""));
    const ColourRange range = colour_range(values, ValueKind::magnitude, 0.1);
    EXPECT_LT(range.high, 1);
    EXPECT_EQ(beyond(range, values), ", scale exceeded");
}

TEST(ColourRange, NoiseAtRestIsNoPattern) {
    for (const ValueKind kind : {ValueKind::magnitude, ValueKind::signed_value}) {
        const ColourRange range = colour_range({1e-12, -3e-12, 2e-12}, kind, 0.1);
        EXPECT_GE(range.high, 0.1 - 1e-12);
        EXPECT_EQ(range.low, kind == ValueKind::signed_value ? -range.high : 0);
    }
}

TEST(ColourRange, OfSeveralFramesHoldsEachOfThem) {
    EXPECT_EQ(joined({0, 0.1}, {-0.2, 0.05}), (ColourRange{-0.2, 0.1}));
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

class UserSettings : public testing::Test {
  protected:
    UserSettings() {
        test::overwrite(home_ / ".gnuplot", "set terminal dumb\nset output\nexit\n");
        set("HOME", home_.path().string()), set("GNUTERM", "nonsense");
    }
    ~UserSettings() override {
        for (const auto& [name, value] : before_)
            value.empty() ? unsetenv(name.c_str()) : setenv(name.c_str(), value.c_str(), 1);
    }

  private:
    void set(const std::string& name, const std::string& value) {
        const char* old = std::getenv(name.c_str());
        before_.emplace_back(name, old ? old : "");
        setenv(name.c_str(), value.c_str(), 1);
    }
    Scratch home_;
    std::vector<std::pair<std::string, std::string>> before_;
};

TEST_F(UserSettings, DoNotReachThePicture) {
    const Scratch folder;
    Plot plot;
    plot.script = "plot x\n";
    const Picture picture = draw(plot, folder / "a.png");
    ASSERT_TRUE(picture.drawn) << picture.message;
    EXPECT_EQ(picture.message, "");
    EXPECT_EQ(png_size(folder / "a.png"), std::pair(2 * plot.width, 2 * plot.height));
    const auto words = command("gnuplot", "plot.gp");
    EXPECT_NE(std::ranges::find(words, "-d"), words.end());
    EXPECT_NE(std::ranges::find(words, "GNUTERM"), words.end());
}

TEST(Gnuplot, DrawsTheOtherFormatsBesideThePng) {
    const Scratch folder;
    Plot plot;
    plot.script = "plot x\n";
    const Picture picture = draw_formats(plot, folder / "a.png", {".png", ".svg", ".pdf"});
    ASSERT_TRUE(picture.drawn) << picture.message;
    EXPECT_EQ(test::contents(folder / "a.png").substr(1, 3), "PNG");
    EXPECT_NE(test::contents(folder / "a.svg").find("<svg"), std::string::npos);
    EXPECT_EQ(test::contents(folder / "a.pdf").substr(0, 4), "%PDF");
    EXPECT_EQ(entries(folder.path()), 3u);
}

TEST(Gnuplot, LongTitlesAreBrokenNotCut) {
    EXPECT_EQ(wrapped("it's short", 700), "'it''s short'");
    const std::vector<std::string> lines = lines_of("one two three four", 100);
    EXPECT_EQ(lines, (std::vector<std::string>{"one two", "three four"}));
    EXPECT_EQ(wrapped("one two three four", 100), "'one two'.\"\\n\".'three four'");
    EXPECT_EQ(lines_of(std::string(60, 'x'), 200).size(), 3u);
    EXPECT_TRUE(lines_of(std::string(600, 'x'), 200).back().ends_with(" ..."));
}

TEST(Gnuplot, LiteralCannotBreakOutOfItsQuotes) {
    EXPECT_EQ(literal("it's"), "'it''s'");
    EXPECT_EQ(literal("a\nsystem(\"x\")"), "'a system(\"x\")'");
}

}  // namespace
}  // namespace sandgraph::report

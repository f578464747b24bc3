#include "dem/packing/csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "base/error.hpp"
#include "yade_reference.hpp"

namespace sandgraph::dem {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::string head = "# {}\n# cell\n# 0.1 0 0 0.1\nid,x,y,r\n";

std::string temporary(const std::string& name) {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    std::string test = std::string(info->test_suite_name()) + "_" + info->name() + "_" + name;
    std::replace(test.begin(), test.end(), '/', '_');
    return testing::TempDir() + test;
}

// The error line for a file with this text; empty when it is accepted.
std::string complaint(const std::string& text) {
    const std::string file = temporary("packing.csv");
    std::ofstream(file) << text;
    try {
        read_packing_csv(file);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(PackingCsv, ReadsTheYadePackings) {
    const Packing p = read_packing_csv(test::yade_file("packing_loose_p32.csv"));
    EXPECT_EQ(p.size(), 400u);
    EXPECT_NEAR(porosity(p), 0.200021, 1e-6);
    EXPECT_EQ(p.H(0, 0), 0.20406085507432525);
    EXPECT_TRUE(p.contacts.empty());
}

TEST(PackingCsv, WritingAndReadingKeepsEveryBit) {
    Packing p = read_packing_csv(test::yade_file("packing_dense_p32.csv"));
    p.H(0, 1) = 1e-6 / 3;
    p.x[7] = std::nextafter(p.x[7], 1.0);
    const std::string file = temporary("round_trip.csv");
    write_packing_csv(file, p, R"({"seed": 1})");
    const Packing again = read_packing_csv(file);
    EXPECT_EQ(again.x, p.x);
    EXPECT_EQ(again.y, p.y);
    EXPECT_EQ(again.r, p.r);
    EXPECT_EQ(again.H, p.H);
}

TEST(PackingCsv, OrdersGrainsById) {
    const std::string file = temporary("order.csv");
    std::ofstream(file) << head << "5,0.08,0.05,0.004\n2,0.02,0.05,0.005\n";
    EXPECT_EQ(read_packing_csv(file).r, (std::vector<double>{0.005, 0.004}));
}

TEST(PackingCsv, AcceptsWindowsLineEndsAndBlankLines) {
    EXPECT_EQ(complaint("# {}\r\n# cell\r\n# 0.1 0 0 0.1\r\nid,x,y,r\r\n0,0.05,0.05,0.005\r\n\r\n"), "");
}

TEST(PackingCsv, AcceptsWhatSpreadsheetsAndEditorsAdd) {
    EXPECT_EQ(
        complaint(
            "\xEF\xBB\xBF# {}\n# cell\n#  +0.1 0 0 0.1 \nid, x, y, r\n# one grain\n0, +0.05 ,0.05,0.005 \n"),
        "");
}

struct Refusal {
    std::string text, place, problem;
};

class PackingCsvRefuses : public testing::TestWithParam<Refusal> {};

TEST_P(PackingCsvRefuses, WithLineProblemAndSuggestion) {
    const std::string error = complaint(GetParam().text);
    EXPECT_THAT(error, AllOf(HasSubstr(GetParam().place), HasSubstr(GetParam().problem), HasSubstr("; ")));
    EXPECT_EQ(error.find('\n'), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
    BadInput, PackingCsvRefuses,
    testing::Values(
        Refusal{"", "packing.csv", "'# {json}' line is missing"},
        Refusal{"# {}\n# cell\nid,x,y,r\n", ".csv:3:", "hxx hxy hyx hyy"},
        Refusal{"# {}\n# cell\n# 0.1 0 0\nid,x,y,r\n", ".csv:3:", "3 numbers for the cell"},
        Refusal{"# {}\n# cell\n# 0.1 0 0 0.1\n0,0.05,0.05,0.005\n", ".csv:4:", "column line is missing"},
        Refusal{"# {}\n# cell\n# 0.1 0.1 0.1 0.1\nid,x,y,r\n0,0,0,0.005\n", ".csv:3:", "cell is singular"},
        Refusal{"# {}\n# cell\n# 3e72 0.04 5 0.01\nid,x,y,r\n0,0,0,0.005\n", ".csv:3:", "cell is too long"},
        Refusal{"# {}\n# cell\n# 0 0.1 0.1 0\nid,x,y,r\n0,0,0,0.005\n", ".csv:3:", "cell is inverted"},
        Refusal{"# {}\n# cell\n# nan 0 0 0.1\nid,x,y,r\n0,0,0,0.005\n", ".csv:3:", "cell is not finite"},
        Refusal{"# {}\n# cell\n# 0.004 0 0 0.1\nid,x,y,r\n0,0,0,0.005\n", ".csv:3:", "smaller than a grain"},
        Refusal{head, ".csv", "no grains"}, Refusal{head + "0,0.05,0.05\n", ".csv:5:", "3 columns"},
        Refusal{head + "0,0.05,0.05,0.005,7\n", ".csv:5:", "5 columns"},
        Refusal{head + "0,0.05,0.05,0.005\n0,0.02,0.02,0.005\n", ".csv:6:", "duplicate id 0"},
        Refusal{head + "0,0.05,abc,0.005\n", ".csv:5:", "'abc' is not a number"},
        Refusal{head + "0,nan,0.05,0.005\n", ".csv:5:", "position is not finite"},
        Refusal{head + "0,0.05,0.05,nan\n", ".csv:5:", "radius nan"},
        Refusal{head + "0,0.05,0.05,0\n", ".csv:5:", "radius 0"},
        Refusal{head + "0,0.05,0.05,-0.005\n", ".csv:5:", "radius -0.005"},
        Refusal{head + "0,0.05,0.05,0.005\n1,0.02,0.02,5e-6\n",
                ".csv:6:", "radius 5e-06 m beside one of 0.005"},
        Refusal{head + "0,1e300,0.05,0.005\n", ".csv:5:", "far outside"},
        Refusal{head + "0,0.05,0.05,0.005\n1,0.051,0.05,0.005\n", ".csv:6:", "overlap by 180 %"},
        Refusal{head + "0,0.05,0.05,0.005\n1,0.057,0.05,0.005\n", ".csv:6:", "overlap by 60 %"},
        Refusal{head + "0,0.001,0.05,0.005\n1,0.099,0.05,0.005\n", ".csv:6:", "overlap by 160 %"}));

TEST(PackingCsv, NamesAMissingFile) { EXPECT_THROW(read_packing_csv("/no/such/packing.csv"), InputError); }

}  // namespace
}  // namespace sandgraph::dem

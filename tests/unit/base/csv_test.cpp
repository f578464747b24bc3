#include "base/csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>

namespace sandgraph {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class Csv : public testing::Test {
  protected:
    std::string file(const std::string& text) {
        std::ofstream(path_, std::ios::binary) << text;
        return path_;
    }
    ~Csv() override { std::filesystem::remove(path_); }

  private:
    std::string path_ = testing::TempDir() + "csv_test_" + std::to_string(getpid()) + ".csv";
};

template <class Call>
std::string complaint(Call call) {
    try {
        call();
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST_F(Csv, TakesWhatSpreadsheetsAndEditorsWrite) {
    CsvReader in(file("\xEF\xBB\xBF# made by hand\r\n\r\n a , b,c \r\n\t \n1, +2 ,-3e1  \t\r\n# end\n4,5,6"));
    ASSERT_TRUE(in.next_row());
    EXPECT_THAT(in.cells(), ElementsAre("a", "b", "c"));
    ASSERT_TRUE(in.next_row());
    EXPECT_EQ(in.line(), 5);
    EXPECT_EQ(in.integer(in.cells()[0]), 1);
    EXPECT_EQ(in.number(in.cells()[1]), 2);
    EXPECT_EQ(in.number(in.cells()[2]), -30);
    ASSERT_TRUE(in.next_row());
    EXPECT_EQ(in.text(), "4,5,6");  // no line end at the end of the file
    EXPECT_FALSE(in.next_row());
}

TEST_F(Csv, TakesCellsInQuotes) {
    CsvReader in(file("\"a\", \"b c\" ,\"\"\n\"1.5\",2,3\n"));
    ASSERT_TRUE(in.next_row());
    EXPECT_THAT(in.cells(), ElementsAre("a", "b c", ""));
    ASSERT_TRUE(in.next_row());
    EXPECT_EQ(in.number(in.cells()[0]), 1.5);
}

TEST_F(Csv, ShowsCommentsToWhoWantsThem) {
    CsvReader in(file("# 0.1 0 0 0.1\nx\n"));
    ASSERT_TRUE(in.next());
    EXPECT_TRUE(in.comment());
    ASSERT_TRUE(in.next());
    EXPECT_FALSE(in.comment());
    EXPECT_FALSE(in.next());
}

TEST_F(Csv, KeepsEmptyCells) {
    CsvReader in(file(",1,\n"));
    ASSERT_TRUE(in.next_row());
    EXPECT_THAT(in.cells(), ElementsAre("", "1", ""));
}

TEST_F(Csv, RefusesNoNumbersWithFileAndLine) {
    CsvReader in(file("\n1,x\n"));
    ASSERT_TRUE(in.next_row());
    for (const char* cell : {"", "x", "1x", "+-1", "+", "1 2", "0x1"})
        EXPECT_THAT(complaint([&] { in.number(cell); }), HasSubstr(".csv:2: '" + std::string(cell) + "'"))
            << cell;
    for (const char* cell : {"1.5", "1e3", ""})
        EXPECT_THAT(complaint([&] { in.integer(cell); }), HasSubstr("a whole number")) << cell;
    EXPECT_TRUE(std::isnan(in.number("nan")));  // the caller knows what a number may be
}

TEST_F(Csv, NamesAFileThatIsNone) {
    EXPECT_THAT(complaint([] { CsvReader("/no/such.csv"); }), HasSubstr("/no/such.csv: cannot be opened"));
    EXPECT_THAT(complaint([] { CsvReader in(testing::TempDir()); }), HasSubstr("it is a folder"));
}

}  // namespace
}  // namespace sandgraph

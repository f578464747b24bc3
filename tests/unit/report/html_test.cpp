#include "report/html.hpp"

#include <gtest/gtest.h>

#include "base/text.hpp"
#include "tests/unit/io/scratch.hpp"

namespace sandgraph::report {
namespace {

TEST(Html, Base64AgreesWithRfc4648) {
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64(std::string("\xff\x00\xfe", 3)), "/wD+");
}

TEST(Html, SceneTextCannotBecomeMarkup) {
    EXPECT_EQ(xml_escaped("<b>\"a\" & b</b>"), "&lt;b&gt;&quot;a&quot; &amp; b&lt;/b&gt;");
    EXPECT_EQ(table({{"<i>"}, {"&"}}).find("<i>"), std::string::npos);
}

TEST(Html, AMissingPictureIsSaidNotLinked) {
    const std::string html = figure("no/such/picture.png", "Load");
    EXPECT_EQ(html.find("<img"), std::string::npos);
    EXPECT_NE(html.find("no picture: Load"), std::string::npos);
}

TEST(Html, RowsLeadToTheirChapters) {
    const std::string html = table({{"run", "N"}, {"my runs/a&b", "2"}}, true, {"", link_to("my runs/a&b")});
    EXPECT_NE(html.find("<a href=\"#my%20runs/a%26b\">my runs/a&amp;b</a>"), std::string::npos) << html;
}

// On a phone a wide table becomes a card a row, whose cells tell their column.
TEST(Html, CellsOfWideTablesNameTheirColumn) {
    const std::string html = table({{"a", "b", "c", "<d>"}, {"1", "2", "3", "4"}});
    EXPECT_NE(html.find("class=\"wide numbers\""), std::string::npos);
    EXPECT_NE(html.find("<td data-label=\"&lt;d&gt;\">4</td>"), std::string::npos) << html;
    EXPECT_EQ(table({{"a", "b"}, {"1", "2"}}).find("wide"), std::string::npos);
}

TEST(Html, ThePageLoadsNothingFromElsewhere) {
    const test::Scratch folder;
    test::overwrite(folder / "load.png", "\x89PNG");
    const std::string html = page("t", table({{"a"}, {"1"}}) + figure(folder / "load.png", "Load"));
    EXPECT_NE(html.find("src=\"data:image/png;base64,"), std::string::npos);
    for (const char* word : {"http://", "https://", "src=\"/", "<script", "<link"})
        EXPECT_EQ(html.find(word), std::string::npos) << word;
}

}  // namespace
}  // namespace sandgraph::report

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

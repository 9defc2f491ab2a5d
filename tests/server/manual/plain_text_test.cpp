#include "server/manual/plain_text.hpp"

#include <gmock/gmock.h>

#include <sstream>

#include "server/manual/guide_text.hpp"

namespace floeplan::manual::plain_text_test {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(PlainText, HasNoMarks) {
  EXPECT_EQ(plain_text("# Data in\n\nSee [the **map**](../guide/map.md#keys), *now*: `--kind` \\*.\n", 80),
            "Data in\n=======\n\nSee the map (floeplan help map), now: --kind *.\n");
}

TEST(PlainText, TellsATableRowByRow) {
  EXPECT_EQ(plain_text("| flag | means |\n|---|---|\n| `--a` | first |\n| Why? | second | third |\n", 80),
            "  - --a: first\n  - Why? second; third\n");
}

TEST(PlainText, KeepsCommandsAsTheyAre) {
  EXPECT_EQ(plain_text("Words\nof a line.\n\n```sh\nfloeplan plan `x` *\n```\n", 80),
            "Words of a line.\n\n    floeplan plan `x` *\n");
}

TEST(PlainText, LeavesOutPicturesAndComments) {
  EXPECT_EQ(plain_text("# A\n\n![jet](jet.svg)\n<!-- for writers -->\nWords.\n", 80), "A\n=\n\nWords.\n");
}

TEST(PlainText, WrapsItemsBelowTheirFirstWord) {
  EXPECT_EQ(plain_text("- one two three four\n2. five\n", 14), "  - one two\n    three four\n  2. five\n");
}

TEST(Guide, IsPartOfTheProgramAndReadableOnATerminal) {
  ASSERT_GE(guide_texts().size(), 12U);
  for (const GuideText& page : guide_texts()) {
    const std::string text = plain_text(page.text, 80);
    EXPECT_THAT(text, testing::StartsWith(std::string{page.title()} + "\n===")) << page.name;
    EXPECT_THAT(text, Not(HasSubstr("]("))) << page.name;
    EXPECT_THAT(text, Not(HasSubstr("**"))) << page.name;
    EXPECT_THAT(text, Not(HasSubstr("<!--"))) << page.name;
  }
}

}  // namespace
}  // namespace floeplan::manual::plain_text_test

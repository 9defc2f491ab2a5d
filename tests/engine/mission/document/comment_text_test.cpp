#include "engine/mission/document/comment_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/property.hpp"

namespace floeplan::mission::comment_text_test {
namespace {

TEST(CommentText, KeepsPlainWords) {
  EXPECT_EQ(comment_text("Ilulissat, leg 2 (#3)", 80), "Ilulissat, leg 2 (#3)");
}

TEST(CommentText, LosesLineBreaksAndControlCharacters) {
  EXPECT_EQ(comment_text("a\r\n\tb_arg: num_waypoints(nodim) 1\x1b[2J", 80),
            "ab_arg: num_waypoints(nodim) 1[2J");
}

TEST(CommentText, LosesWhatIsNotAscii) {
  EXPECT_EQ(comment_text("Disk\xc3\xb8 \xe2\x80\xa8"
                         "Bay",
                         80),
            "Disk Bay");
}

TEST(CommentText, IsCutToItsLimitWithoutATrailingBlank) {
  EXPECT_EQ(comment_text("  one  two", 4), "one");
  EXPECT_EQ(comment_text("one two", 5), "one t");
}

TEST(CommentText, IsOnePrintableLineWhateverTheBytes) {
  support::for_each_seed(500, [](std::mt19937_64& rng) {
    std::string bytes(static_cast<std::size_t>(support::uniform_int(rng, 0, 60)), ' ');
    std::generate(bytes.begin(), bytes.end(),
                  [&] { return static_cast<char>(support::uniform_int(rng, -128, 127)); });

    const std::string text = comment_text(bytes, 40);

    EXPECT_LE(text.size(), 40u);
    EXPECT_TRUE(std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; }));
  });
}

}  // namespace
}  // namespace floeplan::mission::comment_text_test

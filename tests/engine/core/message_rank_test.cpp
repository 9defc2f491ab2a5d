#include "engine/core/message_rank.hpp"

#include <gmock/gmock.h>

namespace floeplan::core::message_rank_test {
namespace {

using testing::ElementsAre;

TEST(MessageRank, TravelsWithTheSentence) {
  const std::string danger = as_danger("the start lies under ice");

  EXPECT_TRUE(is_danger(danger));
  EXPECT_EQ(without_mark(danger), "the start lies under ice");
  EXPECT_FALSE(is_danger("the start lies under ice"));
  EXPECT_EQ(without_mark("a note"), "a note");
}

TEST(MessageRank, PutsDangersFirstAndKeepsTheOrderOfEachRank) {
  const std::vector<std::string> told{"a", as_danger("b"), "c", as_danger("d")};

  EXPECT_THAT(by_rank(told), ElementsAre("Danger: b", "Danger: d", "a", "c"));
  EXPECT_THAT(dangers_among(told), ElementsAre("Danger: b", "Danger: d"));
}

}  // namespace
}  // namespace floeplan::core::message_rank_test

#include "engine/messages/catalogue.hpp"

#include <gmock/gmock.h>

#include <array>
#include <set>

#include "engine/messages/data_messages.hpp"
#include "engine/messages/plan_messages.hpp"
#include "engine/messages/sentence.hpp"
#include "tests/support/golden.hpp"

namespace floeplan::messages::catalogue_test {
namespace {

std::string kind_of_value(const Slot& slot) {
  return std::array{"number", "count", "words"}.at(slot.example.index());
}

/// Every message with the values of its examples.
std::string listing() {
  std::string text;
  for (const Kind& kind : catalogue()) {
    text += std::string{rank_name(kind.rank)} + ' ' + std::string{kind.code};
    for (std::size_t i = 0; i < kind.values(); ++i)
      text += (i == 0 ? " (" : ", ") + std::string{kind.slots[i].name} + ": " + kind_of_value(kind.slots[i]);
    text += (kind.values() > 0 ? ")\n  " : "\n  ") + whole_text(example_of(kind)) + '\n';
  }
  return text;
}

TEST(Catalogue, IsListedWithEveryMessage) { support::expect_golden("messages.txt", listing()); }

TEST(Catalogue, HasOneKindForACode) {
  std::set<std::string_view> codes;
  for (const Kind& kind : catalogue()) {
    EXPECT_TRUE(codes.insert(kind.code).second) << kind.code;
    EXPECT_THAT(std::string{kind.code}, testing::MatchesRegex("[a-z]+([-_][a-z0-9]+)*(/[a-z-]+)?"));
  }
}

TEST(Catalogue, SpeaksOfEveryValue) {
  for (const Kind& kind : catalogue()) {
    const std::string words = std::string{kind.text} + std::string{kind.hint};
    for (std::size_t i = 0; i < kind.values(); ++i) {
      const std::string name{kind.slots[i].name};
      EXPECT_THAT(words,
                  testing::AnyOf(testing::HasSubstr("{" + name + "}"), testing::HasSubstr("{" + name + ":")))
          << kind.code;
    }
  }
}

TEST(Catalogue, NamesTheUnitOfEveryNumber) {
  for (const Kind& kind : catalogue()) {
    for (std::size_t i = 0; i < kind.values(); ++i) {
      if (!std::holds_alternative<double>(kind.slots[i].example)) continue;
      EXPECT_THAT(std::string{kind.slots[i].name},
                  testing::MatchesRegex(".*_(km|m|d|h|min|mj|pct|deg|m_s|millions)"))
          << kind.code;
    }
  }
}

/// A message follows its rank and a colon. Who shows it as a sentence adds the capital and the full stop.
TEST(Catalogue, BeginsSmallUnlessWithANameAndEndsWithoutAFullStop) {
  const auto is_capital = [](char letter) { return letter >= 'A' && letter <= 'Z'; };
  for (const Kind& kind : catalogue()) {
    const bool begins_with_name = kind.text.size() > 1 && is_capital(kind.text[1]);  // GSHHG, TLS
    EXPECT_TRUE(begins_with_name || !is_capital(kind.text.front())) << kind.code;
    for (const std::string_view words : {kind.text, kind.hint})
      EXPECT_TRUE(words.ends_with("...") || !words.ends_with('.')) << kind.code;
  }
}

TEST(Catalogue, SaysWhatToDoAboutEveryDangerOfANewPlan) {
  for (const std::span<const Kind> kinds :
       {std::span<const Kind>{plan_kinds}, std::span<const Kind>{data_kinds}}) {
    for (const Kind& kind : kinds) {
      if (kind.rank == Rank::danger && kind.text != "{remark}") {
        EXPECT_FALSE(kind.hint.empty()) << kind.code;
      }
    }
  }
}

}  // namespace
}  // namespace floeplan::messages::catalogue_test

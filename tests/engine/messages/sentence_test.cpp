#include "engine/messages/sentence.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>

#include "tests/support/property.hpp"

namespace floeplan::messages::sentence_test {
namespace {

using testing::ElementsAre;

Message told(Rank rank, std::string text) { return {.code = "any", .rank = rank, .text = std::move(text)}; }

TEST(Sentence, BeginsWithTheMarkWhereItTellsOfADanger) {
  const std::string danger = sentence(told(Rank::danger, "the start lies under ice"));

  EXPECT_EQ(danger, "Danger: the start lies under ice");
  EXPECT_TRUE(is_danger(danger));
  EXPECT_EQ(without_mark(danger), "the start lies under ice");
  EXPECT_EQ(sentence(told(Rank::caution, "ice is held")), "ice is held");
  EXPECT_FALSE(is_danger("ice is held"));
  EXPECT_EQ(without_mark("ice is held"), "ice is held");
}

TEST(Sentence, EndsWithTheHint) {
  Message message = told(Rank::note, "there is no ice");
  EXPECT_EQ(whole_text(message), "there is no ice");
  message.hint = "ingest some";
  EXPECT_EQ(whole_text(message), "there is no ice; ingest some");
  message.hint = "Ingest some";
  EXPECT_EQ(whole_text(message), "there is no ice. Ingest some");
  message.text = "there is no ice:";
  message.hint = "ingest some";
  EXPECT_EQ(whole_text(message), "there is no ice: ingest some");
}

TEST(Sentence, OfADangerComesFirst) {
  EXPECT_THAT(dangers_first({"a", "Danger: b", "c", "Danger: d"}),
              ElementsAre("Danger: b", "Danger: d", "a", "c"));
}

TEST(Messages, AreOrderedByRankAndKeepTheirOrderWithinOne) {
  support::for_each_seed(200, [](std::mt19937_64& rng) {
    constexpr std::array ranks{Rank::danger, Rank::caution, Rank::note};
    std::vector<Message> messages;
    for (int i = 0; i < 12; ++i) messages.push_back(told(ranks[rng() % ranks.size()], std::to_string(i)));

    const std::vector<Message> ordered = by_rank(messages);

    ASSERT_THAT(ordered, testing::UnorderedElementsAreArray(messages));
    for (std::size_t i = 1; i < ordered.size(); ++i) {
      ASSERT_LE(ordered[i - 1].rank, ordered[i].rank);
      if (ordered[i - 1].rank == ordered[i].rank) {
        ASSERT_LT(std::stoi(ordered[i - 1].text), std::stoi(ordered[i].text));
      }
    }
    const auto dangers = std::ranges::count(messages, Rank::danger, &Message::rank);
    EXPECT_EQ(std::ssize(dangers_among(messages)), dangers);
  });
}

TEST(Ranks, HaveNamesThatAreReadBack) {
  for (const Rank rank : {Rank::danger, Rank::caution, Rank::note})
    EXPECT_EQ(parse_rank(rank_name(rank)), rank);
  EXPECT_EQ(parse_rank("warning"), std::nullopt);
}

}  // namespace
}  // namespace floeplan::messages::sentence_test

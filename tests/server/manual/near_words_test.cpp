#include "server/manual/near_words.hpp"

#include <gmock/gmock.h>

#include <random>

#include "tests/server/manual/small_program.hpp"
#include "tests/support/property.hpp"

namespace floeplan::manual::near_words_test {
namespace {

using testing::Optional;

const std::vector<std::string> commands{"plan",    "evaluate", "reach",   "compare",
                                        "recheck", "ingest",   "datasets"};

/// What the parser makes of words that it refuses.
std::optional<std::string> refused(std::vector<std::string> words) {
  support::SmallProgram program;
  program.app.require_subcommand(1);
  std::ranges::reverse(words);  // as the parser takes them
  try {
    program.app.parse(words);
  } catch (const CLI::ParseError&) {
    return unknown_word(program.app);
  }
  return "nothing was refused";
}

TEST(Nearest, IsTheWordWithTheFewestSlips) {
  EXPECT_EQ(nearest("paln", commands), "plan");
  EXPECT_EQ(nearest("recheck", commands), "recheck");
  EXPECT_EQ(nearest("datasts", commands), "datasets");
  EXPECT_EQ(nearest("simulate", commands), "");
  EXPECT_EQ(nearest("", commands), "");
}

/// Law: one slip in a word of at least four letters is understood.
TEST(Nearest, UnderstandsOneSlip) {
  support::for_each_seed(300, [](std::mt19937_64& rng) {
    const std::string& word = commands[rng() % commands.size()];
    std::string slipped = word;
    const std::size_t at = rng() % (word.size() - 1);
    switch (rng() % 4) {
      case 0: slipped.erase(at, 1); break;
      case 1: slipped.insert(at, 1, 'x'); break;
      case 2: slipped[at] = 'x'; break;
      default: std::swap(slipped[at], slipped[at + 1]);
    }
    EXPECT_EQ(nearest(slipped, commands), word) << slipped;
  });
}

TEST(UnknownWord, IsNamedWithWhatWasMeant) {
  EXPECT_THAT(refused({"paln"}), Optional(std::string{"there is no command paln; did you mean plan?"}));
  EXPECT_THAT(refused({"plan", "--dpart", "2026"}),
              Optional(std::string{"plan has no flag --dpart; did you mean --depart?"}));
  EXPECT_THAT(refused({"plan", "--margn=5"}),
              Optional(std::string{"plan has no flag --margn; did you mean --margin?"}));
  EXPECT_THAT(refused({"datasets", "prone"}),
              Optional(std::string{"datasets has no command prone; did you mean prune?"}));
  EXPECT_THAT(
      refused({"plan", "--nothing-like-it"}),
      Optional(std::string{"plan has no flag --nothing-like-it; floeplan plan --help-all lists them"}));
}

TEST(UnknownWord, IsNoCommandThatTheHelpHides) {
  EXPECT_THAT(refused({"read-file"}),
              Optional(std::string{"there is no command read-file; floeplan --help lists them"}));
}

TEST(UnknownWord, IsNotThereWhereAValueIsWrong) {
  EXPECT_EQ(refused({"plan", "--margin", "wide"}), std::nullopt);
}

}  // namespace
}  // namespace floeplan::manual::near_words_test

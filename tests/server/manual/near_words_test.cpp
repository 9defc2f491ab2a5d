#include "server/manual/near_words.hpp"

#include <gmock/gmock.h>

#include "tests/server/manual/small_program.hpp"

namespace floeplan::manual::near_words_test {
namespace {

using testing::Optional;

const std::vector<std::string> commands{"plan",    "evaluate", "reach",   "compare",
                                        "recheck", "ingest",   "datasets"};

/// The message about an unknown word among words that the parser refuses; empty if they have another fault.
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

TEST(UnknownWord, IsNamedWithWhatWasMeant) {
  EXPECT_THAT(refused({"paln"}),
              Optional(std::string{"there is no command \"paln\"; did you mean \"plan\"?"}));
  EXPECT_THAT(refused({"plan", "--dpart", "2026"}),
              Optional(std::string{"plan has no flag --dpart; did you mean --depart?"}));
  EXPECT_THAT(refused({"plan", "--margn=5"}),
              Optional(std::string{"plan has no flag --margn; did you mean --margin?"}));
  EXPECT_THAT(refused({"datasets", "prone"}),
              Optional(std::string{"datasets has no command \"prone\"; did you mean \"prune\"?"}));
  EXPECT_THAT(
      refused({"plan", "--nothing-like-it"}),
      Optional(std::string{"plan has no flag --nothing-like-it; floeplan plan --help-all lists them"}));
}

TEST(UnknownWord, IsNoCommandThatTheHelpHides) {
  EXPECT_THAT(refused({"read-file"}),
              Optional(std::string{"there is no command \"read-file\"; floeplan --help lists them"}));
}

TEST(UnknownWord, IsNotThereWhereAValueIsWrong) {
  EXPECT_EQ(refused({"plan", "--margin", "wide"}), std::nullopt);
}

}  // namespace
}  // namespace floeplan::manual::near_words_test

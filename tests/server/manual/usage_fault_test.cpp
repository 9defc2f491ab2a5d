#include "server/manual/usage_fault.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/server/manual/small_program.hpp"

namespace floeplan::manual::usage_fault_test {
namespace {

/// The message to the user for words that the parser refuses.
std::string told(std::vector<std::string> words) {
  support::SmallProgram program;
  program.app.require_subcommand(1);
  program.app.get_subcommand("datasets")->require_subcommand(1);
  auto* ingest = program.app.add_subcommand("ingest", "Read files");
  std::string file;
  ingest->add_option("FILE", file)->required();
  auto* from = program.app.get_subcommand("plan")->get_option("--from");
  program.app.get_subcommand("plan")->get_option("--to")->excludes(from);
  std::ranges::reverse(words);  // as the parser takes them
  try {
    program.app.parse(words);
  } catch (const CLI::ParseError& error) {
    return usage_fault(program.app, error);
  }
  return "nothing was refused";
}

TEST(UsageFault, NamesTheFlagAndWhatItTakes) {
  EXPECT_EQ(told({"plan", "--margin", "x"}),
            "--margin must be a number, not \"x\"; see floeplan plan --help");
  EXPECT_EQ(told({"plan", "--workers", "0"}),
            "--workers must be from 1 to 256, not 0; see floeplan plan --help");
  EXPECT_EQ(told({"plan", "--positive", "left"}),
            "--positive must be up or down, not \"left\"; see floeplan plan --help");
  EXPECT_EQ(told({"plan", "--margin"}), "--margin needs a value; see floeplan plan --help");
  EXPECT_EQ(told({"plan", "--from", "a", "--to", "b"}),
            "--from and --to exclude each other; give one of them; see floeplan plan --help");
}

TEST(UsageFault, NamesWhatTheCommandNeedsOrDoesNotTake) {
  EXPECT_EQ(told({}), "floeplan needs a command: plan, datasets or ingest; see floeplan --help");
  EXPECT_EQ(told({"datasets"}), "datasets needs a command: prune; see floeplan datasets --help");
  EXPECT_EQ(told({"ingest"}), "ingest needs FILE; see floeplan ingest --help");
  EXPECT_EQ(told({"plan", "now"}), "plan takes no argument \"now\"; see floeplan plan --help");
}

TEST(UsageFault, AsksWhatWasMeantByAnUnknownWord) {
  EXPECT_EQ(told({"paln"}), "there is no command \"paln\"; did you mean \"plan\"?");
}

}  // namespace
}  // namespace floeplan::manual::usage_fault_test

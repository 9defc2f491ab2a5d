#include "server/manual/help_format.hpp"

#include <gmock/gmock.h>

#include <set>

#include "server/manual/command_help.hpp"
#include "tests/server/manual/small_program.hpp"

namespace floeplan::manual::help_format_test {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Help, OfACommandShowsWhatMostNeedAndCountsTheRest) {
  support::SmallProgram program;
  const std::string help = program.app.get_subcommand("plan")->help("floeplan");

  EXPECT_THAT(help, HasSubstr("Needed most:\n  --from WORD"));
  EXPECT_THAT(help, Not(HasSubstr("--margin")));
  EXPECT_THAT(help, HasSubstr("More with --help-all: Options 2, Ice 3."));
  EXPECT_THAT(help, HasSubstr("Example:\n  floeplan --data store plan --from="));
}

TEST(Help, OfACommandShowsEverythingWhenAsked) {
  support::SmallProgram program;
  const std::string help = program.app.get_subcommand("plan")->help("floeplan", CLI::AppFormatMode::All);

  EXPECT_THAT(help, HasSubstr("\nIce:\n  --margin NUMBER"));
  EXPECT_THAT(help, HasSubstr("--from WORD"));
  EXPECT_THAT(help, testing::ContainsRegex("--workers NUMBER +Flights at once; 1 to 256; default 2\n"));
  EXPECT_THAT(help, testing::ContainsRegex("--positive (up.down|down.up) +Sign of depths\n"));
}

TEST(Help, HidesCommandsThatAreNotForPeople) {
  support::SmallProgram program;

  EXPECT_EQ(program.app.get_subcommand("read-files")->get_group(), "");
  EXPECT_EQ(program.app.get_subcommand("plan")->get_group(), "Plan");
}

TEST(CommandHelps, NameSixFlagsAtMostAndEachCommandOnce) {
  std::set<std::string_view> commands;
  for (const CommandHelp& help : command_helps()) {
    EXPECT_TRUE(commands.insert(help.command).second) << help.command;
    EXPECT_LE(help.needed_most.size(), 6U) << help.command;
    EXPECT_THAT(std::string{help.example}, HasSubstr(std::string{help.command})) << help.command;
  }
}

}  // namespace
}  // namespace floeplan::manual::help_format_test

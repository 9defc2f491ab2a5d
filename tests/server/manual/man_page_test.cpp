#include "server/manual/man_page.hpp"

#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>

#include "tests/server/manual/small_program.hpp"
#include "tests/support/temporary_folder.hpp"

namespace floeplan::manual::man_page_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::vector<Command>& commands() {
  static const std::vector<Command> all = commands_of(support::SmallProgram{}.app);
  return all;
}

TEST(ManPages, AreOnePageForEachCommandThatTheHelpShows) {
  std::vector<std::string> names;
  for (const Command& command : commands()) names.push_back(man_name(command));

  EXPECT_THAT(names,
              ElementsAre("floeplan", "floeplan-plan", "floeplan-datasets", "floeplan-datasets-prune"));
}

TEST(ManPages, TellFlagsExampleAndWhatToSeeAlso) {
  const std::string plan = man_page(commands()[1], commands());
  EXPECT_THAT(
      plan,
      HasSubstr(
          ".SS Ice\n.TP\n\\fB\\-\\-margin\\fR \\fINUMBER\\fR\nDistance that's kept from ice, metres\n"));
  EXPECT_THAT(plan, HasSubstr(".SH EXAMPLE\n.nf\nfloeplan \\-\\-data store plan"));
  EXPECT_THAT(plan, HasSubstr(".SH SEE ALSO\n.BR floeplan (1)\n"));
  EXPECT_THAT(man_page(commands()[2], commands()), HasSubstr(".BR floeplan\\-datasets\\-prune (1)\n"));
}

/// man itself formats each page without a warning, where it is installed.
TEST(ManPages, AreReadByMan) {
  if (std::system("command -v man > /dev/null && command -v groff > /dev/null") != 0)
    GTEST_SKIP() << "install the packages man-db and groff to run this test";
  const support::TemporaryFolder folder;
  for (const Command& command : commands()) {
    const std::filesystem::path page = folder.path() / (man_name(command) + ".1");
    std::ofstream{page} << man_page(command, commands());
    const std::string warnings = (folder.path() / "warnings").string();
    ASSERT_EQ(std::system(("man --warnings -l " + page.string() + " > /dev/null 2> " + warnings).c_str()), 0);
    EXPECT_EQ(std::filesystem::file_size(warnings), 0U) << page;
  }
}

}  // namespace
}  // namespace floeplan::manual::man_page_test

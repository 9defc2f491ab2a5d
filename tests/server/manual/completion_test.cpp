#include "server/manual/completion.hpp"

#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "tests/server/manual/small_program.hpp"
#include "tests/support/temporary_folder.hpp"

namespace floeplan::manual::completion_test {
namespace {

using testing::HasSubstr;
using testing::Not;

std::vector<Command> commands() { return commands_of(support::SmallProgram{}.app); }

bool is_there(const std::string& program) {
  return std::system(("command -v " + program + " > /dev/null").c_str()) == 0;
}

/// What bash offers at the end of the words.
std::string offered(const std::string& words) {
  const support::TemporaryFolder folder;
  std::ofstream{folder.path() / "script"} << completion("bash", commands()) << "COMP_WORDS=(" << words
                                          << ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_floeplan\n"
                                             "echo \"${COMPREPLY[*]}\"\n";
  const std::string command =
      "bash " + (folder.path() / "script").string() + " > " + (folder.path() / "out").string() + " 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << words;
  std::ifstream out{folder.path() / "out"};
  return {std::istreambuf_iterator<char>{out}, {}};
}

TEST(BashCompletion, OffersCommandsAndThenTheirFlags) {
  EXPECT_EQ(offered("floeplan pl"), "plan\n");
  EXPECT_EQ(offered("floeplan --data store plan --mar"), "--margin\n");
  EXPECT_EQ(offered("floeplan datasets pr"), "prune\n");
  EXPECT_EQ(offered("floeplan datasets prune --dry"), "--dry-run\n");
  EXPECT_EQ(offered("floeplan read"), "\n") << "hidden";
}

/// The shell itself reads the script, where it is installed.
TEST(Completion, IsAScriptOfItsShell) {
  const support::TemporaryFolder folder;
  for (const std::string& shell : shells()) {
    EXPECT_THAT(completion(shell, commands()), HasSubstr("margin"));
    if (!is_there(shell)) continue;
    const std::filesystem::path script = folder.path() / shell;
    std::ofstream{script} << completion(shell, commands());
    EXPECT_EQ(std::system((shell + " -n " + script.string()).c_str()), 0) << shell;
  }
}

TEST(Completion, IsRefusedForAnotherShell) {
  EXPECT_THROW((void)completion("csh", commands()), std::invalid_argument);
}

}  // namespace
}  // namespace floeplan::manual::completion_test

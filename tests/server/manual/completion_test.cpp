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

/// The completions that bash offers at the end of the words.
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

class Completion : public testing::TestWithParam<std::string> {};

TEST_P(Completion, IsAScriptThatItsShellReads) {
  const std::string script = completion(GetParam(), commands());
  EXPECT_THAT(script, HasSubstr("margin"));
  if (!is_there(GetParam())) GTEST_SKIP() << GetParam() << " is not installed";
  const support::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "script";
  std::ofstream{path} << script;

  EXPECT_EQ(std::system((GetParam() + " -n " + path.string()).c_str()), 0);
}

INSTANTIATE_TEST_SUITE_P(Shells, Completion, testing::ValuesIn(shells()),
                         [](const auto& shell) { return shell.param; });

/// The completions that fish offers at the end of the words, one on each line, without descriptions.
TEST(FishCompletion, OffersCommandsAndThenTheirFlags) {
  if (!is_there("fish")) GTEST_SKIP() << "fish is not installed";
  const support::TemporaryFolder folder;
  std::ofstream{folder.path() / "script"} << completion("fish", commands());
  const std::filesystem::path empty = folder.path() / "empty";  // fish also offers the files of its folder
  std::filesystem::create_directory(empty);
  const auto offered_by_fish = [&](const std::string& words) {
    const std::string command = "cd " + empty.string() + " && HOME=" + folder.path().string() +
                                " fish --no-config -c 'source " + (folder.path() / "script").string() +
                                "; complete -C \"" + words + "\"' > " + (folder.path() / "out").string();
    EXPECT_EQ(std::system(command.c_str()), 0) << words;
    std::ifstream out{folder.path() / "out"};
    return std::string{std::istreambuf_iterator<char>{out}, {}};
  };

  EXPECT_THAT(offered_by_fish("floeplan pl"), testing::StartsWith("plan"));
  EXPECT_THAT(offered_by_fish("floeplan plan --mar"), testing::StartsWith("--margin"));
  EXPECT_THAT(offered_by_fish("floeplan datasets pr"), testing::StartsWith("prune"));
}

/// Prints the line that a Tab makes of the words of its second argument, in an interactive zsh that ran its first.
constexpr const char* zsh_with_tab = R"(
zmodload zsh/zpty
zpty shell zsh -f -i
zpty -w shell "unset zle_bracketed_paste; PS1=; autoload -Uz compinit; $1"
zpty -w shell 'show() { print -r -- "<$BUFFER>" }; zle -N show; bindkey "^X" show; print READ""Y'
zpty -r shell line '*READY*'
zpty -w -n shell "$2"$'\t\x18'
zpty -r shell line '*<*>*'
print -r -- "${${line##*<}%%>*}"
zpty -d shell
)";

TEST(ZshCompletion, OffersCommandsAndThenTheirFlags) {
  if (!is_there("zsh")) GTEST_SKIP() << "zsh is not installed";
  const support::TemporaryFolder folder;
  std::ofstream{folder.path() / "_floeplan"} << completion("zsh", commands());
  std::ofstream{folder.path() / "tab"} << zsh_with_tab;
  const std::string here = folder.path().string();
  const std::string from_folder = "fpath=(" + here + " $fpath); compinit -D -u";
  const std::string sourced = "compinit -D -u; source " + here + "/_floeplan";
  const auto completed = [&](const std::string& words, const std::string& set_up) {
    const std::string command =
        "timeout 60 zsh -f " + here + "/tab '" + set_up + "' '" + words + "' > " + here + "/out";
    EXPECT_EQ(std::system(command.c_str()), 0) << words;
    std::ifstream out{folder.path() / "out"};
    return std::string{std::istreambuf_iterator<char>{out}, {}};
  };

  for (const std::string& set_up : {from_folder, sourced}) {
    EXPECT_EQ(completed("floeplan pl", set_up), "floeplan plan \n");
    EXPECT_EQ(completed("floeplan datasets pr", set_up), "floeplan datasets prune \n");
    EXPECT_THAT(completed("floeplan plan --mar", set_up), testing::StartsWith("floeplan plan --margin"));
  }
}

TEST(Completions, AreRefusedForAnotherShell) {
  EXPECT_THROW((void)completion("csh", commands()), std::invalid_argument);
}

}  // namespace
}  // namespace floeplan::manual::completion_test

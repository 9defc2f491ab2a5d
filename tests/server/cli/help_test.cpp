#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>

#include "engine/messages/catalogue.hpp"
#include "engine/messages/sentence.hpp"
#include "server/manual/command_help.hpp"
#include "server/manual/guide_text.hpp"
#include "tests/server/cli/program.hpp"

namespace floeplan::cli::help_test {
namespace {

using manual::CommandHelp;
using support::Outcome;
using support::Program;
using testing::HasSubstr;
using testing::Not;

std::vector<std::string> words_of(std::string_view command) {
  std::istringstream stream{std::string{command}};
  return {std::istream_iterator<std::string>{stream}, {}};
}

TEST(Help, ListsTheCommandsInGroups) {
  const Outcome help = Program{}.run({"--help"});

  ASSERT_EQ(help.exit_code, 0) << help.err;
  for (const CommandHelp& command : manual::command_helps()) {
    if (!command.group.empty()) {
      EXPECT_THAT(help.out, HasSubstr("\n  " + std::string{command.command} + ' '));
    }
  }
  EXPECT_THAT(help.out, Not(HasSubstr("read-files")));
}

/// Law: every flag that the help of a command shows first is a flag of the command, and --help-all shows it,
/// too.
TEST(Help, OfEveryCommandBeginsWithFlagsThatItHasAndEndsWithAnExample) {
  const Program program;
  for (const CommandHelp& command : manual::command_helps()) {
    std::vector<std::string> words = words_of(command.command);
    words.emplace_back("--help");
    const Outcome help = program.run(words);
    words.back() = "--help-all";
    const Outcome all = program.run(words);

    ASSERT_EQ(help.exit_code, 0) << command.command << ": " << help.err;
    ASSERT_EQ(all.exit_code, 0) << command.command << ": " << all.err;
    for (const std::string_view flag : command.needed_most) {
      EXPECT_THAT(help.out, HasSubstr(flag)) << command.command;
      EXPECT_THAT(all.out, HasSubstr(flag)) << command.command;
    }
    EXPECT_THAT(help.out, HasSubstr("Example:\n  floeplan " + std::string{command.example}))
        << command.command;
    EXPECT_GE(all.out.size(), command.needed_most.empty() ? help.out.size() : help.out.size() + 100);
  }
}

TEST(Help, SaysTheUnitTheDefaultOrAnExampleOfEveryValue) {
  const Program program;
  const std::regex value{R"(\n  --[a-z-]+[^\n ]* (?:NUMBER|INTEGER|TEXT) +([^\n]*(?:\n {10,}[^\n]*)*))"};
  // A list of what may be given is as good as an example.
  const std::regex told{"default|example|without|such as| to [0-9]|, as |: [a-z0-9]+(,| or )"};
  for (const CommandHelp& command : manual::command_helps()) {
    std::vector<std::string> words = words_of(command.command);
    words.emplace_back("--help-all");
    const std::string help = program.run(words).out;
    for (std::sregex_iterator at{help.begin(), help.end(), value}, end; at != end; ++at)
      EXPECT_TRUE(std::regex_search((*at)[1].str(), told)) << command.command << ':' << at->str();
  }
}

TEST(Help, OfAPlanFitsOnAScreen) {
  const std::string help = Program{}.run({"plan", "--help"}).out;

  EXPECT_LE(std::ranges::count(help, '\n'), 25) << help;
}

TEST(Help, ShowsThePagesOfTheGuide) {
  const Program program;
  const Outcome list = program.run({"help"});
  for (const manual::GuideText& page : manual::guide_texts()) {
    EXPECT_THAT(list.out, HasSubstr(page.title()));
    const Outcome shown = program.run({"help", std::string{page.name}});
    EXPECT_EQ(shown.exit_code, 0);
    EXPECT_THAT(shown.out, testing::StartsWith(std::string{page.title()} + '\n'));
  }
  EXPECT_THAT(program.run({"help", "plan"}).out, HasSubstr("--max-hold"));
}

/// The links of printed texts: what the pages, the help of all commands and the messages name can be printed, too.
TEST(Help, NamesOnlyTopicsAndCommandsThatThereAre) {
  const Program program;
  std::string texts;
  std::set<std::string> known;
  for (const manual::GuideText& page : manual::guide_texts()) {
    known.emplace(page.name);
    texts += program.run({"help", std::string{page.name}}).out;
  }
  for (const CommandHelp& command : manual::command_helps()) {
    std::vector<std::string> words = words_of(command.command);
    if (!words.empty()) known.insert(words.front());
    words.emplace_back("--help-all");
    texts += program.run(words).out;
  }
  for (const messages::Kind& kind : messages::catalogue())
    texts += messages::whole_text(example_of(kind)) + '\n';

  const std::set<std::string> verbs{"at", "lists", "needs"};  // of sentences about the program
  const std::regex named{R"(\bfloeplan\s(?:--(?:data|store) \S+ )?(?:help\s)?([a-z][a-z-]+))"};
  int found = 0;
  for (std::sregex_iterator at{texts.begin(), texts.end(), named}, end; at != end; ++at) {
    if (verbs.contains((*at)[1])) continue;
    EXPECT_TRUE(known.contains((*at)[1])) << at->str();
    ++found;
  }
  EXPECT_GT(found, 150);
}

TEST(Help, SaysWhatWasMeant) {
  const Program program;
  const Outcome topic = program.run({"help", "planing"});
  EXPECT_EQ(topic.exit_code, 2);
  EXPECT_THAT(topic.err, HasSubstr("there is no topic \"planing\"; did you mean \"planning\"?"));
  const Outcome command = program.run({"paln"});
  EXPECT_EQ(command.exit_code, 2);
  EXPECT_THAT(command.err, HasSubstr("there is no command \"paln\"; did you mean \"plan\"?"));
  const Outcome flag = program.run({"plan", "--dpart", "2026-11-22T06:00:00Z"});
  EXPECT_EQ(flag.exit_code, 2);
  EXPECT_THAT(flag.err, HasSubstr("plan has no flag --dpart; did you mean --depart?"));
}

TEST(Help, SaysThatAFlagOfAllCommandsStandsBeforeTheCommand) {
  const Program program;

  const Outcome late = program.run({"plan", "--data", "store"});

  EXPECT_EQ(late.exit_code, 2);
  EXPECT_THAT(late.err, HasSubstr("--data must stand before the command; write floeplan --data ... plan"));
}

TEST(Manual, IsWrittenAsAPackageHasIt) {
  const Program program;
  const std::filesystem::path share = program.folder() / "share";
  ASSERT_EQ(program.run({"write-manual", share.string()}).exit_code, 0);

  for (const char* file : {"man/man1/floeplan.1", "man/man1/floeplan-plan.1",
                           "man/man1/floeplan-datasets-prune.1", "bash-completion/completions/floeplan",
                           "zsh/vendor-completions/_floeplan", "fish/vendor_completions.d/floeplan.fish"})
    EXPECT_TRUE(std::filesystem::exists(share / file)) << file;
}

/// The whole output for the demonstration plan is longer than a screen.
TEST(PlanOutput, IsASummaryWithDangersFirstUnlessAllIsAskedFor) {
  const Program program;
  const std::filesystem::path demo = program.folder() / "demo";
  ASSERT_EQ(program.run({"demo", demo.string(), "--start", "2026-11-22"}).exit_code, 0);
  std::vector<std::string> ingest{"ingest"};
  for (const auto& entry : std::filesystem::directory_iterator{demo})
    if (entry.path().extension() != ".txt") ingest.push_back(entry.path().string());
  ASSERT_EQ(program.run(ingest).exit_code, 0);
  std::vector<std::string> plan{"plan",     "--from=-53.2,69.2",    "--to=-52.95,69.2",
                                "--depart", "2026-11-22T06:00:00Z", "--max-waypoints",
                                "6",        "--icebergs-as-of",     "2026-11-20T00:00:00Z"};
  const Outcome summary = program.run(plan);
  plan.emplace_back("--verbose");
  const Outcome everything = program.run(plan);

  ASSERT_EQ(summary.exit_code, 0) << summary.err;
  std::istringstream lines{summary.out};
  int beside_waypoints = 0;
  for (std::string line; std::getline(lines, line);) {
    const bool is_waypoint =
        line.starts_with("no. ") ||
        (line.size() > 40 && (std::isdigit(line[0]) || line[0] == 'S') && line.find("2026-11-2") > 20);
    beside_waypoints += is_waypoint ? 0 : 1;
  }
  EXPECT_LE(beside_waypoints, 25) << summary.out;
  EXPECT_THAT(summary.out, Not(HasSubstr("note: ")));
  EXPECT_THAT(summary.out, HasSubstr("\nenergy "));
  EXPECT_THAT(summary.out, HasSubstr("\nleast distance to land "));
  EXPECT_THAT(summary.out, Not(HasSubstr("to icebergs"))) << "what is not known";
  EXPECT_THAT(summary.out, Not(HasSubstr("places to surface"))) << "there is no ice on the route";
  EXPECT_LT(summary.out.find("caution: "), summary.out.find("no. "));
  EXPECT_THAT(everything.out, HasSubstr("data: "));
  EXPECT_THAT(everything.out, HasSubstr("refined"));
}

}  // namespace
}  // namespace floeplan::cli::help_test

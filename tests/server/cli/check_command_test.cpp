#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/server/cli/program.hpp"

namespace floeplan::cli::check_command_test {
namespace {

using nlohmann::json;
using support::Outcome;
using support::Program;
using ::testing::HasSubstr;

std::string write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream{file, std::ios::binary} << text;
  return file.string();
}

const std::string yo = "behavior_name=yo\n<start:b_arg>\nb_arg: d_target_depth(m) 180\n<end:b_arg>\n";

TEST(Check, AnswersForEveryFileAndFailsWhenOneIsRejected) {
  const Program program;
  const std::string good = write(program.folder() / "yo10.ma", yo);
  const std::string bad = write(program.folder() / "bad.mi", "b_arg: overtime(sec) 1\nbehavior: abend\n");

  const Outcome both = program.run({"check", good, bad, "--json"});
  const Outcome one = program.run({"check", good, "--json"});

  EXPECT_EQ(both.exit_code, 3);
  ASSERT_EQ(both.json().size(), 2U);
  EXPECT_EQ(both.json()[0]["file"], good);
  EXPECT_EQ(both.json()[0]["verdict"], "ok");
  EXPECT_EQ(both.json()[1]["verdict"], "reject");
  EXPECT_EQ(both.json()[1]["messages"][0]["line"], 1);
  EXPECT_EQ(one.exit_code, 0);
}

TEST(Check, TellsAPersonVerdictAndReasons) {
  const Program program;
  const Outcome outcome = program.run({"check", write(program.folder() / "surfac10.ma", yo)});

  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("surfac10.ma: warn, yo\n"));
  EXPECT_THAT(outcome.out, HasSubstr("line 1: warning: "));
}

TEST(Check, RejectsWhatCannotBeRead) {
  const Program program;
  std::filesystem::create_directories(program.folder() / "empty");
  for (const std::string& file :
       {(program.folder() / "empty").string(), (program.folder() / "none.ma").string(),
        write(program.folder() / "large.ma", std::string(100'000, 'x')),
        write(program.folder() / "junk.ma", std::string(100, '\0'))}) {
    const Outcome outcome = program.run({"check", file, "--json"});
    EXPECT_EQ(outcome.exit_code, 3) << file;
    EXPECT_EQ(outcome.json()[0]["verdict"], "reject") << file;
  }
  EXPECT_EQ(program.run({"check"}).exit_code, 2);
}

TEST(Check, ReadsTheMissionFilesOfAFolder) {
  const Program program;
  const std::filesystem::path folder = program.folder() / "mission";
  std::filesystem::create_directories(folder);
  write(folder / "yo10.ma", yo);
  write(folder / "floe.mi", "behavior: abend\n");
  write(folder / "README.txt", "not a mission");

  const auto answers = program.run({"check", folder.string(), "--json"}).json();

  ASSERT_EQ(answers.size(), 2U);
  EXPECT_EQ(answers[0]["file"], (folder / "floe.mi").string());
  EXPECT_EQ(answers[1]["file"], (folder / "yo10.ma").string());
  std::filesystem::create_directories(program.folder() / "empty");
  EXPECT_THAT(program.run({"check", (program.folder() / "empty").string()}).out,
              testing::AllOf(HasSubstr("empty: refused\n"), HasSubstr("the folder holds no mission files")));
}

const std::string list =
    "behavior_name=goto_list\n<start:b_arg>\nb_arg: list_when_wpt_dist(m) 500\nb_arg: num_waypoints(nodim) "
    "1\n"
    "<end:b_arg>\n<start:waypoints>\n-5230.0000\t6900.0000\n<end:waypoints>\n";

TEST(Check, WithADepartureFollowsTheRouteThroughTheStoredData) {
  const Program program;
  const std::string file = write(program.folder() / "goto_l10.ma", list);

  const Outcome clear =
      program.run({"check", file, "--depart", "2026-11-22T06:00:00Z", "--from=-53,69", "--json"});
  const Outcome wrong = program.run({"check", file, "--depart", "soon"});

  EXPECT_EQ(clear.exit_code, 0) << clear.err;
  EXPECT_THAT(clear.json()[0]["messages"].dump(), HasSubstr("route_clear"));
  EXPECT_EQ(wrong.exit_code, 3);
  EXPECT_THAT(wrong.err, HasSubstr("floeplan: --depart"));
}

}  // namespace
}  // namespace floeplan::cli::check_command_test

#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "tests/server/cli/program.hpp"
#include "tests/server/cli/served_program.hpp"
#include "tests/support/places.hpp"

namespace floeplan::cli::examples_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using support::Outcome;
using testing::HasSubstr;

const char* const bed =
    "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 50\ncellsize 0.5\n-900 -800 70\n-600 -5 4\n";

std::string text_of(const fs::path& file) {
  std::ifstream stream{file, std::ios::binary};
  return {std::istreambuf_iterator<char>{stream}, {}};
}

/// Each example in Python and in shell, against a server that wants a token.
class Examples : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    if (std::system("curl --version > /dev/null 2>&1") != 0)
      GTEST_SKIP() << "install the package curl to run this test";
  }

  /// Runs a script with the server's address and more words.
  [[nodiscard]] Outcome run(const std::string& script, const std::string& words,
                            const std::string& token = "") const {
    const fs::path out = folder() / "script.out";
    const fs::path err = folder() / "script.err";
    const std::string command =
        "PYTHONDONTWRITEBYTECODE=1 FLOEPLAN_TOKEN=" + (token.empty() ? token_ : token) + " timeout 60 " +
        support::source_folder() + "/api/examples/" + script + GetParam() + ' ' + served_.address() + ' ' +
        words + " > " + out.string() + " 2> " + err.string();
    const int status = std::system(command.c_str());
    return {WEXITSTATUS(status), text_of(out), text_of(err)};
  }
  [[nodiscard]] fs::path write(const std::string& name, const std::string& content) const {
    std::ofstream{folder() / name} << content;
    return folder() / name;
  }
  [[nodiscard]] fs::path folder() const { return program_.folder(); }
  [[nodiscard]] fs::path inputs_to(const json& goal) const {
    return write("inputs.json",
                 json{{"from", {-53, 69}}, {"to", goal}, {"depart", "2026-11-22T06:00:00Z"}}.dump());
  }

  support::Program program_;
  const std::string token_{
      program_.run({"token", "add", "ship", "--role", "pilot", "--json"}).json()["token"]};
  support::ServedProgram served_{program_.folder() / "store"};
};

TEST_P(Examples, PlanWaitAndFetchTheNewestMission) {
  const Outcome planned = run("plan_and_wait", inputs_to({-52.8, 69.05}).string());
  ASSERT_EQ(planned.exit_code, 0) << planned.err;
  const json answer = planned.json();
  const std::string plan = answer.value("/plan/plan_id"_json_pointer, answer.value("plan_id", ""));

  const fs::path missions = folder() / "missions";
  const Outcome fetched = run("newest_mission", missions.string());

  EXPECT_EQ(fetched.exit_code, 0) << fetched.err;
  const fs::path file = fetched.out.substr(0, fetched.out.find('\n'));
  EXPECT_THAT(file.string(), HasSubstr(plan));
  EXPECT_THAT(text_of(file), HasSubstr("goto_l10.ma"));
}

TEST_P(Examples, SayWhatAServerRefuses) {
  const Outcome faulty = run("plan_and_wait", inputs_to({-520, 69}).string());
  EXPECT_EQ(faulty.exit_code, 1);
  EXPECT_THAT(faulty.err, HasSubstr("/inputs/to"));

  const Outcome unknown = run("newest_mission", folder().string(), "floeplan_guessed");
  EXPECT_EQ(unknown.exit_code, 1);
  EXPECT_THAT(unknown.err, HasSubstr("token"));
  EXPECT_EQ(run("newest_mission", folder().string()).exit_code, 1) << "there is no plan yet";
  EXPECT_EQ(run("watch_events", "none").exit_code, 1);
  EXPECT_EQ(run("nightly_ingest", "").exit_code, 2);
}

TEST_P(Examples, IngestFilesTogetherAndTellWhichWereRefused) {
  const std::string depths = write("bed.asc", bed).string();
  const std::string zone =
      write("zone.geojson", R"({"type": "FeatureCollection", "features": [{"type": "Feature",
    "properties": {"kind": "no_go"}, "geometry": {"type": "Polygon",
    "coordinates": [[[-53.1, 68.9], [-52.8, 68.9], [-52.8, 69.1], [-53.1, 68.9]]]}}]})")
          .string();
  EXPECT_EQ(run("nightly_ingest", zone).exit_code, 0);
  const Outcome both = run("nightly_ingest", zone + ' ' + depths);
  EXPECT_EQ(both.exit_code, 3) << "its depths do not say which way is up";
  EXPECT_THAT(both.out, HasSubstr("unchanged"));
}

TEST_P(Examples, WatchAJobUntilItsEnd) {
  const std::string header = "Authorization: Bearer " + token_ + "\r\nPrefer: respond-async\r\n";
  const json job = served_
                       .ask("POST", "/processes/echo/execution", header,
                            json{{"inputs", {{"echo", "teststring"}, {"pause", 1}}}}.dump())
                       .json();

  const Outcome watched = run("watch_events", job.at("jobID"));

  EXPECT_EQ(watched.exit_code, 0) << watched.err;
  EXPECT_THAT(watched.out, HasSubstr("successful"));
}

INSTANTIATE_TEST_SUITE_P(InPythonAndShell, Examples, testing::Values(".py", ".sh"),
                         [](const auto& script) { return script.param == ".py" ? "Python" : "Shell"; });

}  // namespace
}  // namespace floeplan::cli::examples_test

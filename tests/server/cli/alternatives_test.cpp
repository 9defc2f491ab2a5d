#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "tests/server/cli/program.hpp"

namespace floeplan::cli::alternatives_test {
namespace {

using nlohmann::json;
using support::Outcome;
using support::Program;
using testing::HasSubstr;
using testing::SizeIs;

/// A closed area across the straight way, its larger part to the north.
std::string closed_area(const Program& program) {
  const std::string file = program.folder() / "closed.geojson";
  std::ofstream{file}
      << R"({"type":"Feature","properties":{"kind":"no_go","name":"trawling"},"geometry":{"type":"Polygon",
    "coordinates":[[[-53.05,69.17],[-52.95,69.17],[-52.95,69.22],[-53.05,69.22],[-53.05,69.17]]]}})";
  return file;
}

Outcome plan(const Program& program, std::vector<std::string> more) {
  std::vector<std::string> words{
      "plan",    "--from=-53.20,69.18", "--to=-52.80,69.18", "--depart", "2026-11-22T06:00:00Z",
      "--areas", closed_area(program)};
  words.insert(words.end(), more.begin(), more.end());
  return program.run(words);
}

TEST(Alternatives, AreStoredAsPlansAndNamedInThePlan) {
  const Program program;

  const json best = plan(program, {"--alternatives", "1", "--json"}).json();

  ASSERT_THAT(best["alternatives"], SizeIs(1));
  const json& other = best["alternatives"][0];
  EXPECT_GT(other["travel_time_s"], best["travel_time_s"]);
  EXPECT_THAT(other["message"]["text"].get<std::string>(), HasSubstr("north of the closed area"));
  const Outcome compared = program.run({"compare", best["plan_id"], other["plan_id"]});
  EXPECT_EQ(compared.exit_code, 0) << compared.err;
}

TEST(Alternatives, AreNamedInTheSummary) {
  const Program program;

  const Outcome outcome = plan(program, {"--alternatives", "3"});

  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("\nalternative 1 (p"));
  EXPECT_THAT(plan(program, {"--alternatives", "3", "--verbose"}).out,
              HasSubstr("note: fewer alternatives were found than requested. 1 route on other sides of "
                        "obstacles was tried"));
}

TEST(Alternatives, AreRefusedForAWindowOfDepartures) {
  const Program program;

  const Outcome outcome = plan(program, {"--alternatives", "1", "--depart-until", "2026-11-22T12:00:00Z"});

  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("--alternatives: are not possible with a departure window"));
}

}  // namespace
}  // namespace floeplan::cli::alternatives_test

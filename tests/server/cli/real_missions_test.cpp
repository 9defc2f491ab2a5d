#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "tests/server/cli/program.hpp"
#include "tests/server/cli/served_program.hpp"

namespace floeplan::cli::real_missions_test {
namespace {

using nlohmann::json;
using support::Program;
using support::shared_sample;
using ::testing::HasSubstr;

const char* const juan_de_fuca = "currents/gnome_gridded_current.nc";
const char* const newfoundland = "currents/nrt_global_allsat_phy_l4_20190223_20190226.nc";
const char* const world_depths = "bathymetry/topo_30min.nc";
const char* const sightings_2014 = "icebergs/IIP_2014IcebergSeason_a.csv";

bool have(const std::vector<std::string>& samples) {
  return std::ranges::all_of(samples,
                             [](const auto& name) { return std::filesystem::exists(shared_sample(name)); });
}

void ingest(const Program& program, const std::vector<std::string>& samples) {
  std::vector<std::string> words{"ingest", "--json"};
  for (const std::string& sample : samples) words.push_back(shared_sample(sample).string());
  const auto outcome = program.run(words);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const json& dataset : outcome.json()["datasets"]) EXPECT_EQ(dataset["status"], "stored");
}

/// Places and times of a plan, without the values that differ from run to run.
json course_of(const json& plan) {
  json course;
  for (const json& waypoint : plan["waypoints"]) course.push_back({waypoint["lon"], waypoint["lat"]});
  return course;
}

TEST(JuanDeFuca, GivesOtherPlansForDeparturesSixHoursApart) {
  if (!have({juan_de_fuca, world_depths})) GTEST_SKIP() << "the shared sample files are not here";
  const Program program;
  ingest(program, {juan_de_fuca, world_depths});
  const std::vector<std::pair<std::string, std::string>> missions{
      {"-125.7,47.2", "-125.4,47.45"}, {"-125.6,47.7", "-125.3,47.5"}, {"-125.8,47.5", "-125.5,47.3"}};

  for (const auto& [from, to] : missions) {
    std::vector<json> courses;
    for (const char* depart : {"2023-03-02T12:00:00Z", "2023-03-02T18:00:00Z", "2023-03-03T00:00:00Z"}) {
      const auto outcome = program.run({"plan", "--from", from, "--to", to, "--depart", depart, "--json"});
      ASSERT_EQ(outcome.exit_code, 0) << from << ' ' << to << ' ' << depart << ": " << outcome.err;
      const json plan = outcome.json();
      EXPECT_EQ(plan["status"], "ok");
      EXPECT_EQ(plan["departure"], depart);
      EXPECT_THAT(plan["warnings"].dump(), HasSubstr("coarse"));
      for (const json& course : courses) EXPECT_NE(course, course_of(plan));
      courses.push_back(course_of(plan));
    }
  }
}

TEST(JuanDeFuca, ProbesTheFilesOwnValueAtANode) {
  if (!have({juan_de_fuca})) GTEST_SKIP() << "the shared sample files are not here";
  const Program program;
  ingest(program, {juan_de_fuca});

  // Inside: the value half way between two nodes and two times lies between its neighbours'. Outside: a reason.
  const auto inside =
      program.run({"probe", "--at", "-125.6,47.3", "--time", "2023-03-02T13:00:00Z", "--json"}).json();
  const auto outside =
      program.run({"probe", "--at", "-120,47.3", "--time", "2023-03-02T13:00:00Z", "--json"}).json();

  EXPECT_TRUE(inside["currents"]["u_m_s"].is_number());
  EXPECT_EQ(inside["currents"]["time_before"], "2023-03-02T12:00:00Z");
  EXPECT_EQ(inside["currents"]["time_after"], "2023-03-02T15:00:00Z");
  EXPECT_TRUE(outside["currents"]["u_m_s"].is_null());
  EXPECT_FALSE(outside["currents"]["reason"].get<std::string>().empty());
}

TEST(Newfoundland, KeepsAKilometreFromEveryIcebergOfTheLastDays) {
  if (!have({newfoundland, world_depths, sightings_2014}))
    GTEST_SKIP() << "the shared sample files are not here";
  const Program program;
  ingest(program, {newfoundland, world_depths, sightings_2014});

  const auto outcome = program.run({"plan", "--from", "-51.5,47.8", "--to", "-47.0,47.2", "--depart",
                                    "2014-04-30T12:00:00Z", "--steady", "--margin", "1000", "--json"});

  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json plan = outcome.json();
  EXPECT_GE(plan["clearances"]["iceberg_m"].get<double>(), 1000.0);
  EXPECT_THAT(plan["warnings"].dump(), HasSubstr("held steady"));
  EXPECT_THAT(plan["warnings"].dump(), HasSubstr("coarse"));
}

TEST(Newfoundland, RefusesADepartureOutsideTheCurrentsUnlessTheyAreHeldSteady) {
  if (!have({newfoundland})) GTEST_SKIP() << "the shared sample files are not here";
  const Program program;
  ingest(program, {newfoundland});

  const auto outcome = program.run(
      {"plan", "--from", "-51.5,47.8", "--to", "-47.0,47.2", "--depart", "2014-04-30T12:00:00Z", "--json"});

  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("--steady"));
}

/// Everything but how long the search took.
json without_duration(json plan) {
  plan["search"].erase("seconds");
  return plan;
}

TEST(JuanDeFuca, GivesTheSamePlanOverHttpAsOnTheCommandLine) {
  if (!have({juan_de_fuca, world_depths})) GTEST_SKIP() << "the shared sample files are not here";
  const Program program;
  ingest(program, {juan_de_fuca, world_depths});
  const support::ServedProgram served{program.folder() / "store"};

  for (const char* depart : {"2023-03-02T12:00:00Z", "2023-03-02T18:00:00Z"}) {
    const auto answer =
        served.execute("plan-route", {{"from", {-125.7, 47.2}}, {"to", {-125.4, 47.45}}, {"depart", depart}});
    const auto printed =
        program.run({"plan", "--from", "-125.7,47.2", "--to", "-125.4,47.45", "--depart", depart, "--json"});

    ASSERT_EQ(answer.status, 200) << answer.body;
    EXPECT_EQ(without_duration(answer.json()["plan"]), without_duration(printed.json()));
  }
}

TEST(Newfoundland, GivesTheSamePlanOverHttpAsOnTheCommandLine) {
  if (!have({newfoundland, world_depths, sightings_2014}))
    GTEST_SKIP() << "the shared sample files are not here";
  const Program program;
  ingest(program, {newfoundland, world_depths, sightings_2014});
  const support::ServedProgram served{program.folder() / "store"};

  const auto answer = served.execute("plan-route", {{"from", {-51.5, 47.8}},
                                                    {"to", {-47.0, 47.2}},
                                                    {"depart", "2014-04-30T12:00:00Z"},
                                                    {"steady", true},
                                                    {"margin_m", 1000}});
  const auto printed = program.run({"plan", "--from", "-51.5,47.8", "--to", "-47.0,47.2", "--depart",
                                    "2014-04-30T12:00:00Z", "--steady", "--margin", "1000", "--json"});

  ASSERT_EQ(answer.status, 200) << answer.body;
  EXPECT_EQ(without_duration(answer.json()["plan"]), without_duration(printed.json()));
  const std::string files =
      "/collections/plans/items/" + answer.json()["plan"]["plan_id"].get<std::string>() + "/mission";
  EXPECT_EQ(served.get(files).status, 409)
      << "the season's older sightings are ignored, and nobody confirmed that";
  const auto mission = served.get(files + "?accept_dangers=true");
  EXPECT_EQ(mission.status, 200);
  EXPECT_EQ(mission.json()["files"][0]["name"], "goto_l10.ma");
}

TEST(RealFiles, AreUnchangedTheSecondTime) {
  if (!have({juan_de_fuca})) GTEST_SKIP() << "the shared sample files are not here";
  const Program program;
  ingest(program, {juan_de_fuca});

  const auto again = program.run({"ingest", shared_sample(juan_de_fuca).string(), "--json"});

  EXPECT_EQ(again.exit_code, 0);
  EXPECT_EQ(again.json()["datasets"][0]["status"], "unchanged");
  EXPECT_EQ(program.run({"datasets", "--json"}).json()["datasets"].size(), 1U);
}

TEST(RealFiles, ArePlannedEvaluatedAndExportedAlike) {
  if (!have({juan_de_fuca})) GTEST_SKIP() << "the shared sample files are not here";
  const Program program;
  ingest(program, {juan_de_fuca});
  const json plan = program
                        .run({"plan", "--from", "-125.7,47.2", "--to", "-125.4,47.45", "--depart",
                              "2023-03-02T12:00:00Z", "--json"})
                        .json();
  ASSERT_EQ(plan["status"], "ok");
  const std::string id = plan["plan_id"];

  const auto evaluated = program.run({"evaluate", id, "--depart", "2023-03-02T12:00:00Z", "--json"}).json();
  const auto exported =
      program.run({"export", id, "--out", (program.folder() / "mission").string(), "--json"});
  const auto again = program.run({"export", id, "--out", (program.folder() / "mission").string()});

  const double seconds = plan["travel_time_s"];
  EXPECT_NEAR(evaluated["travel_time_s"].get<double>(), seconds, 2e-4 * seconds);
  ASSERT_EQ(exported.exit_code, 0) << exported.err;
  std::ifstream list{exported.json()["files"][0].get<std::string>()};
  std::string first_line;
  std::getline(list, first_line);
  EXPECT_EQ(first_line, "behavior_name=goto_list");
  EXPECT_EQ(again.exit_code, 1) << "an export never overwrites without being told";
}

}  // namespace
}  // namespace floeplan::cli::real_missions_test

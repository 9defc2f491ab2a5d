#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/server/cli/program.hpp"

namespace floeplan::cli::simulate_command_test {
namespace {

using nlohmann::json;
using support::Outcome;
using support::Program;
using testing::HasSubstr;

/// A short plan over the demonstration's sea bed, in still water.
class SimulateCli : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists("/usr/share/gmt-gshhg/binned_GSHHS_f.nc"))
      GTEST_SKIP() << "install the package gmt-gshhg-full to run this test";
    const auto demo = program_.folder() / "demo";
    ASSERT_EQ(program_.run({"demo", demo.string(), "--start", "2026-11-22"}).exit_code, 0);
    ASSERT_EQ(program_.run({"ingest", (demo / "disko-synthetic-bathymetry.tif").string()}).exit_code, 0);
    const Outcome plan = program_.run({"plan", "--from=-53.0,69.0", "--to=-52.8,69.02", "--depart",
                                       "2026-11-22T06:00:00Z", "--spacing", "500", "--no-refine", "--json"});
    ASSERT_EQ(plan.exit_code, 0) << plan.err;
    plan_id_ = plan.json()["plan_id"];
  }

  [[nodiscard]] Outcome simulate(const std::vector<std::string>& more) const {
    std::vector<std::string> words{"simulate", plan_id_, "--json"};
    words.insert(words.end(), more.begin(), more.end());
    return program_.run(words);
  }

  [[nodiscard]] static json without_speed(const Outcome& outcome) {
    json document = outcome.json();
    document.erase("real_time_factor");
    return document;
  }

  const Program program_;
  std::string plan_id_;
};

TEST_F(SimulateCli, FliesAPlanToItsGoalAndWritesWhatItFlew) {
  const auto out = program_.folder() / "out";

  const Outcome outcome = simulate({"--no-avoidance", "--out", out.string()});

  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json document = outcome.json();
  EXPECT_EQ(document["arrived"], 1) << document["flights"].dump(2);
  EXPECT_EQ(document["collisions"], 0);
  EXPECT_NEAR(document["flights"][0]["travel_time_s"].get<double>(),
              document["planned_travel_time_s"].get<double>(),
              0.1 * document["planned_travel_time_s"].get<double>());
  const std::string id = document["simulation_id"];
  EXPECT_TRUE(std::filesystem::exists(out / (id + ".nc")));
  std::ifstream file{out / (id + ".geojson")};
  const json tracks = json::parse(file);
  EXPECT_EQ(tracks["features"][0]["geometry"]["type"], "LineString");
}

TEST_F(SimulateCli, GivesTheSameAnswerWithAnyNumberOfWorkers) {
  const std::vector<std::string> batch{"--runs",          "3",    "--seed",        "9",
                                       "--current-error", "0.05", "--no-avoidance"};
  auto with_one = batch;
  with_one.insert(with_one.end(), {"--workers", "1"});
  auto with_three = batch;
  with_three.insert(with_three.end(), {"--workers", "3"});

  const Outcome one = simulate(with_one);
  const Outcome three = simulate(with_three);

  ASSERT_EQ(one.exit_code, 0) << one.err;
  EXPECT_EQ(without_speed(one), without_speed(three));
  EXPECT_EQ(one.json()["statistics"]["runs"], 3);
}

TEST_F(SimulateCli, RefusesWhatCannotBeFlownAndSaysWhy) {
  EXPECT_THAT(simulate({"--vehicle", "slocum-g3-1000"}).err, HasSubstr("is for slocum-g3-200"));
  EXPECT_EQ(simulate({"--runs", "0"}).exit_code, 2);
  EXPECT_EQ(simulate({"--scenario", "random-icebergs"}).exit_code, 2);
  EXPECT_THAT(program_.run({"simulate", "p000000000000"}).err, HasSubstr("no plan has the id"));

  const auto broken = program_.folder() / "goto_l10.ma";
  std::ofstream{broken} << "behavior_name=goto_list\n<start:b_arg>\n  b_arg: num_waypoints(nodim) 1\n";
  const Outcome outcome = simulate({"--mission", broken.string()});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("goto_l10.ma"));
}

TEST(SimulateScenario, FliesTheSameFieldsWithAnyNumberOfWorkers) {
  const Program program;
  const std::vector<std::string> words{"simulate", "--scenario",     "random-icebergs", "--runs",
                                       "3",        "--no-avoidance", "--json",          "--workers"};
  auto with_one = words;
  with_one.emplace_back("1");
  auto with_two = words;
  with_two.emplace_back("2");

  json one = program.run(with_one).json();
  json two = program.run(with_two).json();

  EXPECT_EQ(one["runs"], 3);
  EXPECT_TRUE(one.contains("collisions") && one.contains("arrived") && one.contains("median_detour_pct"));
  EXPECT_TRUE(one.at("beyond_help").is_number() && one.at("runs_given_up").is_array());
  one.erase("real_time_factor");
  two.erase("real_time_factor");
  EXPECT_EQ(one, two);
}

}  // namespace
}  // namespace floeplan::cli::simulate_command_test

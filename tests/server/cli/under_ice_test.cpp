#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "engine/core/utc_text.hpp"
#include "tests/server/cli/program.hpp"

namespace floeplan::cli::under_ice_test {
namespace {

using nlohmann::json;
using support::Outcome;
using support::Program;
using ::testing::HasSubstr;

/// The demonstration's sea: a field of drift ice in the south of the bay, open in its middle.
class UnderIceCli : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists("/usr/share/gmt-gshhg/binned_GSHHS_f.nc"))
      GTEST_SKIP() << "install the package gmt-gshhg-full to run this test";
    const auto demo = program_.folder() / "demo";
    ASSERT_EQ(program_.run({"demo", demo.string(), "--start", "2026-11-22"}).exit_code, 0);
    std::vector<std::string> ingest{"ingest"};
    for (const char* file : {"disko-synthetic-bathymetry.tif", "disko-synthetic-ice.nc"})
      ingest.push_back((demo / file).string());
    ASSERT_EQ(program_.run(ingest).exit_code, 0);
  }

  /// Plans from west to east through the ice, in still water.
  [[nodiscard]] Outcome plan(const std::vector<std::string>& more) const {
    std::vector<std::string> words{"plan",
                                   "--from=-53.15,68.95",
                                   "--to=-51.75,69.0",
                                   "--depart",
                                   "2026-11-22T00:00:00Z",
                                   "--spacing",
                                   "1500",
                                   "--json"};
    words.insert(words.end(), more.begin(), more.end());
    return program_.run(words);
  }

  const Program program_;
};

TEST_F(UnderIceCli, ListsAndProbesTheIce) {
  const json datasets = program_.run({"datasets", "--json"}).json()["datasets"];
  EXPECT_TRUE(std::ranges::any_of(datasets, [](const json& dataset) { return dataset["kind"] == "ice"; }));

  const json in_ice =
      program_.run({"probe", "--at=-52.6,68.96", "--time", "2026-11-22T12:00:00Z", "--json"}).json();
  EXPECT_GT(in_ice["ice_concentration"], 0.5);
  EXPECT_TRUE(in_ice["ice_concentration_reason"].is_null());
  EXPECT_GT(in_ice["ice"]["thickness_m"], 0.2);
  EXPECT_EQ(in_ice["ice"]["time_after"], "2026-11-23T00:00:00Z");

  const json later =
      program_.run({"probe", "--at=-52.6,68.96", "--time", "2026-12-22T12:00:00Z", "--json"}).json();
  EXPECT_TRUE(later["ice_concentration"].is_null());
  EXPECT_THAT(later["ice_concentration_reason"], HasSubstr("outside the period"));
}

TEST_F(UnderIceCli, BoundsTheTimeWithoutASurfacingAndSaysSoOfEveryWaypoint) {
  const Outcome free = plan({});
  const Outcome bounded = plan({"--max-time-without-surfacing", "50400", "--escape-plan"});

  ASSERT_EQ(free.exit_code, 0) << free.err;
  ASSERT_EQ(bounded.exit_code, 0) << bounded.err;
  const double longest = free.json()["surfacing"]["longest_without_surfacing_s"];
  EXPECT_GT(longest, 50400.0);
  const json document = bounded.json();
  EXPECT_LE(document["surfacing"]["longest_without_surfacing_s"], 50400.0);
  EXPECT_EQ(document["surfacing"]["escapes"].size(), document["waypoints"].size());
  EXPECT_GE(document["travel_time_s"], free.json()["travel_time_s"]);
  for (const json& waypoint : document["waypoints"]) {
    EXPECT_TRUE(waypoint["may_surface"].is_boolean());
    EXPECT_LE(waypoint["since_last_surfacing_s"], 50400.0);
  }
}

/// Every output has the same sum of the stretches below ice.
TEST_F(UnderIceCli, SaysInEveryOutputHowLongItIsBelowIce) {
  const Outcome outcome = plan({"--max-leg", "60000", "--no-refine"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json planned = outcome.json();
  const json& surfacing = planned["surfacing"];
  const std::string id = planned["plan_id"];

  double sum_m = 0.0;
  double legs_m = 0.0;
  for (const json& stretch : surfacing["below_ice"]) sum_m += stretch["distance_m"].get<double>();
  for (const json& waypoint : planned["waypoints"])
    if (waypoint["leg_upper_turn_m"].is_number() && waypoint["leg_upper_turn_m"] > 0.0)
      legs_m += waypoint["leg_m"].get<double>();
  ASSERT_GT(sum_m, 1000.0);
  EXPECT_LT(sum_m, legs_m) << "legs lie partly in open water";
  EXPECT_NEAR(surfacing["below_ice_m"], sum_m, 1e-6);
  const auto figure = [](double value, const char* format) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), format, value);
    return std::string{text.data()};
  };
  const std::string km = figure(sum_m / 1000.0, "%.1f km, ");
  const std::string hours = core::hours_minutes(core::Seconds{surfacing["below_ice_s"].get<double>()});

  // The same plan again, as a table: it has the same id only if nothing of it differs.
  const Outcome table =
      program_.run({"plan", "--from=-53.15,68.95", "--to=-51.75,69.0", "--depart", "2026-11-22T00:00:00Z",
                    "--spacing", "1500", "--max-leg", "60000", "--no-refine"});
  EXPECT_THAT(table.out + table.err, HasSubstr("below ice or icebergs for " + km + hours));
  const auto out = program_.folder() / "brief";
  ASSERT_EQ(
      program_.run({"export", id, "--format", "html", "--out", out.string(), "--accept-dangers"}).exit_code,
      0);
  std::string brief;
  for (const auto& entry : std::filesystem::directory_iterator{out}) {
    std::ifstream file{entry.path()};
    brief.assign(std::istreambuf_iterator<char>{file}, {});
  }
  EXPECT_THAT(brief, HasSubstr("Below ice or icebergs: " + km));
  const Outcome compared = program_.run({"compare", id, id, "--json"});
  EXPECT_EQ(compared.json()["first"]["below_ice_m"], surfacing["below_ice_m"]);
}

TEST_F(UnderIceCli, SaysWhyThereIsNoPlan) {
  // The goal lies in the ice, more than an hour from its edge.
  const Outcome outcome =
      program_.run({"plan", "--from=-53.15,68.95", "--to=-52.65,68.96", "--depart", "2026-11-22T00:00:00Z",
                    "--spacing", "1500", "--max-time-without-surfacing", "3600", "--json"});

  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.json()["reason"], "no_surfacing");
  EXPECT_THAT(outcome.err, HasSubstr("--max-time-without-surfacing"));
}

TEST_F(UnderIceCli, SimulatesWhatAGliderCouldNotBeSent) {
  const Outcome planned = plan({"--max-leg", "2500", "--no-refine"});
  ASSERT_EQ(planned.exit_code, 0) << planned.err;
  const std::string id = planned.json()["plan_id"];

  const Outcome exported = program_.run(
      {"export", id, "--full", "--safe=-53.15,68.95", "--out", (program_.folder() / "out").string()});
  const Outcome simulated = program_.run({"simulate", id, "--no-avoidance", "--json"});

  EXPECT_EQ(exported.exit_code, 3);
  EXPECT_THAT(exported.err, HasSubstr("too many below ice"));
  ASSERT_EQ(simulated.exit_code, 0) << simulated.err;
  EXPECT_EQ(simulated.json()["arrived"], 1) << simulated.json()["flights"].dump(2);
}

TEST_F(UnderIceCli, NamesWhatIsWrongWithTheInput) {
  EXPECT_THAT(plan({"--max-concentration-to-surface", "15"}).err,
              HasSubstr("floeplan: --max-concentration-to-surface"));
  EXPECT_EQ(plan({"--max-concentration-to-surface", "15"}).exit_code, 3);
  EXPECT_THAT(plan({"--ice", "ice-00000000"}).err, HasSubstr("floeplan: --ice"));
  EXPECT_EQ(plan({"--ice", "ice-00000000"}).exit_code, 3);
  const Outcome without = plan({"--ice", "none"});
  EXPECT_EQ(without.exit_code, 0);
  EXPECT_TRUE(without.json()["surfacing"].is_null());
}

}  // namespace
}  // namespace floeplan::cli::under_ice_test

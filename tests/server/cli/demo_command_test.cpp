#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <sstream>

#include "engine/core/utc_text.hpp"
#include "tests/server/cli/program.hpp"
#include "tests/support/places.hpp"

namespace floeplan::cli::demo_command_test {
namespace {

using nlohmann::json;
using support::Outcome;
using support::Program;
using ::testing::HasSubstr;

/// Writes a scenario, reads it into the store and plans what the program proposes, with more arguments at its end.
class DemoCli : public testing::Test {
 protected:
  [[nodiscard]] Outcome write(const std::vector<std::string>& more) const {
    std::vector<std::string> words{"demo", (program_.folder() / "demo").string(), "--json"};
    words.insert(words.end(), more.begin(), more.end());
    return program_.run(words);
  }

  void ingest(const json& written) const {
    std::vector<std::string> words{"ingest", "--json"};
    for (const json& file : written["files"]) words.push_back(file);
    const Outcome outcome = program_.run(words);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json document = outcome.json();
    for (const json& dataset : document["datasets"]) EXPECT_EQ(dataset["status"], "stored") << dataset;
  }

  /// The request that the program proposes, on a coarse grid and unrefined, so that it takes seconds.
  [[nodiscard]] static std::vector<std::string> example_of(const json& written) {
    auto words = written["example"].get<std::vector<std::string>>();
    words.insert(words.end(), {"--spacing", "1200", "--no-refine", "--no-optimality-gap", "--json"});
    return words;
  }

  const Program program_;
};

TEST_F(DemoCli, BeginsTodayAtMidnightUnlessToldOtherwise) {
  const auto midnight = [] {
    return std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now());
  };
  const auto before = midnight();
  const Outcome outcome = write({"--scenario", "river"});
  const auto after = midnight();

  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string start = outcome.json()["start"];
  EXPECT_THAT(start, testing::AnyOf(core::iso8601(before), core::iso8601(after)));
  ingest(outcome.json());
  const json datasets = program_.run({"datasets", "--json"}).json()["datasets"];
  EXPECT_TRUE(std::ranges::any_of(datasets, [&](const json& dataset) {
    return dataset["time_start"] == start;
  })) << datasets.dump(2);
}

TEST_F(DemoCli, KnowsCurrentsIceAndIcebergsOfThisHour) {
  if (!std::filesystem::exists("/usr/share/gmt-gshhg/binned_GSHHS_f.nc"))
    GTEST_SKIP() << "install the package gmt-gshhg-full to run this test";
  ingest(write({}).json());

  const json here = program_.run({"probe", "--at=-52.6,68.96", "--json"}).json();  // of now, without --time

  EXPECT_TRUE(here["currents"]["u_m_s"].is_number()) << here;
  EXPECT_GT(here["ice_concentration"], 0.5) << here;
  const json datasets = program_.run({"datasets", "--json"}).json()["datasets"];
  const auto bergs = std::ranges::find(
      datasets, "icebergs", [](const json& dataset) { return dataset["kind"].get<std::string>(); });
  ASSERT_NE(bergs, datasets.end());
  const auto last_seen = core::parse_iso8601((*bergs)["time_end"].get<std::string>());
  ASSERT_TRUE(last_seen.has_value());
  const core::UtcTime now = std::chrono::system_clock::now();
  EXPECT_LE(*last_seen, now);
  EXPECT_GT(*last_seen, now - std::chrono::days{2});
}

TEST_F(DemoCli, PlansWhatItProposesWithoutACaution) {
  if (!std::filesystem::exists("/usr/share/gmt-gshhg/binned_GSHHS_f.nc"))
    GTEST_SKIP() << "install the package gmt-gshhg-full to run this test";
  const json written = write({"--start", "2026-11-22"}).json();
  ingest(written);
  auto words = written["example"].get<std::vector<std::string>>();
  words.push_back("--json");

  const Outcome outcome = program_.run(words);

  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const json& message : outcome.json()["messages"]) EXPECT_EQ(message["rank"], "note") << message;
}

TEST_F(DemoCli, TakesADateOrATimeWithItsZoneAndNothingElse) {
  EXPECT_EQ(write({"--scenario", "river", "--start", "2026-11-22"}).json()["start"], "2026-11-22T00:00:00Z");
  EXPECT_EQ(write({"--scenario", "river", "--start", "2026-11-22T02:00:00+02:00"}).json()["start"],
            "2026-11-22T00:00:00Z");
  for (const char* start : {"", "today", "2026-11-22T06:00:00", "2026-02-30", "22.11.2026"}) {
    const Outcome refused = write({"--scenario", "river", "--start", start});
    EXPECT_EQ(refused.exit_code, 2) << start;
    EXPECT_THAT(refused.err, HasSubstr("--start")) << start;
  }
}

TEST_F(DemoCli, WaitsForTheTideInTheStraitHoweverEarlyItDeparts) {
  const json written = write({"--scenario", "strait", "--start", "2027-03-05"}).json();
  ingest(written);
  const auto plan = [&](const std::string& depart, const std::vector<std::string>& more) {
    auto words = example_of(written);
    std::erase(words, "--no-refine");  // which leaves short legs to and fro in the place of holds
    *std::next(std::ranges::find(words, "--depart")) = depart;
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = program_.run(words);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.json();
  };
  const auto arrival_s = [](const json& document) {
    return core::unix_seconds(core::parse_iso8601(document["arrival"].get<std::string>()).value());
  };
  const std::string early = "2027-03-05T06:00:00Z";  // as proposed
  const std::string late = "2027-03-05T08:00:00Z";

  const json tidal = plan(early, {});
  const json still = plan(early, {"--currents", "none"});

  double waited_s = 0.0;
  for (const json& waypoint : tidal["waypoints"]) waited_s += waypoint["wait_s"].get<double>();
  EXPECT_GT(waited_s, 1'800.0) << tidal["waypoints"];
  // Two hours earlier, the plan can at most use an earlier part of the same slack water.
  const double gained_s = arrival_s(plan(late, {})) - arrival_s(tidal);
  EXPECT_GT(gained_s, -900.0);
  EXPECT_LT(gained_s, 3'600.0);
  for (const json& waypoint : still["waypoints"]) EXPECT_EQ(waypoint["wait_s"], 0.0);
  EXPECT_NEAR(arrival_s(plan(late, {"--currents", "none"})) - arrival_s(still), 7'200.0, 5.0);
}

TEST_F(DemoCli, PassesFromLeadToLeadBelowThePackIceWithoutACaution) {
  const json written = write({"--scenario", "pack-ice", "--start", "2027-03-05"}).json();
  ingest(written);
  auto words = written["example"].get<std::vector<std::string>>();
  words.push_back("--json");

  const Outcome outcome = program_.run(words);

  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json plan = outcome.json();
  for (const json& message : plan["messages"]) EXPECT_EQ(message["rank"], "note") << message;
  EXPECT_LE(plan["surfacing"]["longest_without_surfacing_s"], 43'200.0);
  EXPECT_GE(plan["surfacing"]["below_ice"].size(), 4U);
}

TEST_F(DemoCli, PassesSouthOfTheLeadsOfThePackIceWithoutALimit) {
  const json written = write({"--scenario", "pack-ice", "--start", "2027-03-05"}).json();
  ingest(written);
  auto words = example_of(written);
  const auto limit = std::ranges::find(words, "--max-time-without-surfacing");
  ASSERT_NE(limit, words.end());
  words.erase(limit, limit + 2);

  const Outcome outcome = program_.run(words);

  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_GT(outcome.json()["surfacing"]["longest_without_surfacing_s"], 2.0 * 36'000.0);
  EXPECT_FALSE(outcome.json()["dangers"].empty());
}

TEST_F(DemoCli, PrintsCommandsThatWorkWhenCopied) {
  const std::filesystem::path folder = program_.folder() / "my demo";
  const Outcome written = program_.run_alone({"demo", folder.string(), "--scenario", "river"});
  ASSERT_EQ(written.exit_code, 0) << written.err;

  std::string script = "set -e; cd '" + program_.folder().string() + "'\nfloeplan() { '" +
                       support::program_folder() + "/floeplan' \"$@\"; }\n";
  std::istringstream lines{written.err};
  int commands = 0;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("  floeplan")) continue;
    script += line + " >> printed\n";
    ++commands;
  }

  EXPECT_EQ(commands, 2) << written.err;
  EXPECT_EQ(std::system(script.c_str()), 0) << script;
}

}  // namespace
}  // namespace floeplan::cli::demo_command_test

#include <gmock/gmock.h>

#include <fstream>

#include "tests/server/cli/program.hpp"

namespace floeplan::cli::zones_test {
namespace {

using nlohmann::json;
using support::Outcome;
using support::Program;
using testing::HasSubstr;

/// Plans in still, deep water past a stored zone; nothing else is in the store.
class StoredZones : public testing::Test {
 protected:
  Outcome ingest(const std::string& name, const std::string& properties, const std::string& west_east) {
    const std::string file = (program_.folder() / name).string();
    const std::string west = west_east.substr(0, west_east.find(','));
    const std::string east = west_east.substr(west_east.find(',') + 1);
    std::ofstream{file} << R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{)"
                        << properties << R"(},"geometry":{"type":"Polygon","coordinates":[[[)" << west
                        << ",68.9],[" << east << ",68.9],[" << east << ",69.1],[" << west << ",69.1],["
                        << west << R"(,68.9]]]}}]})";
    return program_.run({"ingest", file, "--json"});
  }

  Outcome plan(std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"plan", "--from=-53.25,69", "--to=-52.75,69", "--depart",
                               "2026-11-22T06:00:00Z", "--spacing", "1000", "--json"});
    return program_.run(more);
  }

  Program program_;
};

TEST_F(StoredZones, AreGoneRoundListedAndLeftOutOnRequest) {
  const double straight_m = plan().json()["distance_m"];
  const Outcome stored = ingest("range.geojson", R"("kind":"no_go","name":"range")", "-53.1,-52.9");
  ASSERT_EQ(stored.exit_code, 0) << stored.err;
  const std::string id = stored.json()["datasets"][0]["dataset_id"];
  EXPECT_EQ(stored.json()["datasets"][0]["kind"], "zones");

  const json round = plan().json();
  EXPECT_GT(round["distance_m"].get<double>(), 1.2 * straight_m);
  EXPECT_EQ(round["datasets"][0]["id"], id);
  EXPECT_EQ(plan({"--zones", id}).json()["distance_m"], round["distance_m"]);
  const json through = plan({"--zones", "none"}).json();
  EXPECT_NEAR(through["distance_m"].get<double>(), straight_m, 1.0);
  EXPECT_THAT(through["warnings"].dump(), HasSubstr("does not obey them"));

  const Outcome evaluated =
      program_.run({"evaluate", through["plan_id"], "--depart", "2026-11-22T06:00:00Z", "--json"});
  EXPECT_EQ(evaluated.exit_code, 1);
  EXPECT_EQ(evaluated.json()["reason"], "in_zone");
  EXPECT_THAT(program_.run({"probe", "--at=-53,69"}).out, HasSubstr("zone      range, no_go, in force"));
}

TEST_F(StoredZones, OfATimeThatIsOverBindNobody) {
  const double straight_m = plan().json()["distance_m"];
  ASSERT_EQ(ingest("old.geojson", R"("kind":"no_go","until":"2026-11-21")", "-53.1,-52.9").exit_code, 0);

  EXPECT_NEAR(plan().json()["distance_m"].get<double>(), straight_m, 1.0);
}

TEST_F(StoredZones, ToStayInHoldThePlanInside) {
  ASSERT_EQ(ingest("box.geojson", R"("kind":"stay_in","name":"box")", "-53.3,-53.0").exit_code, 0);

  const Outcome outside = plan();
  EXPECT_EQ(outside.exit_code, 1);
  EXPECT_EQ(outside.json()["reason"], "goal_in_zone");
}

TEST_F(StoredZones, WithFaultsAreRefusedWithEachOfThem) {
  const Outcome refused = ingest("bad.geojson", R"("kind":"no_go","from":"soon","top_m":-4)", "-53.3,-53.0");
  EXPECT_EQ(refused.exit_code, 3);
  EXPECT_EQ(refused.json()["datasets"][0]["errors"].size(), 2U) << refused.out;
}

}  // namespace
}  // namespace floeplan::cli::zones_test

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/server/cli/program.hpp"
#include "tests/server/cli/served_program.hpp"
#include "tests/server/jobs/wait_until.hpp"

namespace floeplan::cli::simulations_over_http_test {
namespace {

using nlohmann::json;
using support::wait_until;
using ::testing::HasSubstr;

const char* const deep_bed =
    "ncols 3\nnrows 3\nxllcorner 0\nyllcorner 50\ncellsize 0.5\n900 900 900\n900 900 900\n900 900 900\n";

/// A plan of 4 km in still water, made and flown over HTTP.
class SimulationsOverHttp : public testing::Test {
 protected:
  void SetUp() override {
    const json upload = served_.upload(deep_bed, "?name=bed.asc").json();
    const auto ingested = served_.execute("ingest", {{"uploads", {upload.at("id")}}, {"positive", "down"}});
    ASSERT_EQ(ingested.status, 200) << ingested.body;
    const auto planned = served_.execute("plan-route", {{"from", {0.5, 50.5}},
                                                        {"to", {0.55, 50.51}},
                                                        {"depart", "2026-11-22T06:00:00Z"},
                                                        {"spacing_m", 500}});
    ASSERT_EQ(planned.status, 200) << planned.body;
    plan_id_ = planned.json().at("plan").at("plan_id");
  }

  [[nodiscard]] json flights(int runs) const {
    return {{"plan_id", plan_id_}, {"runs", runs}, {"seed", 7}, {"tracks", 0}};
  }
  [[nodiscard]] std::string status_of(const std::string& job) const {
    return served_.get("/jobs/" + job).json().value("status", "gone");
  }

  const support::Program program_;
  const support::ServedProgram served_{program_.folder() / "store", {"--workers", "2"}};
  std::string plan_id_;
};

TEST_F(SimulationsOverHttp, ArriveWhenThePlanSays) {
  const auto flown = served_.execute("simulate-plan", flights(2));

  ASSERT_EQ(flown.status, 200) << flown.body;
  const json simulation = flown.json().at("simulation");
  EXPECT_EQ(simulation.at("arrived"), 2) << simulation.dump(2);
  const double planned_s = simulation.at("planned_travel_time_s");
  const double speed_m_s = simulation.at("flights")[0].at("distance_m").get<double>() /
                           simulation.at("flights")[0].at("travel_time_s").get<double>();
  EXPECT_NEAR(speed_m_s, 0.35, 0.02) << planned_s;
}

TEST_F(SimulationsOverHttp, EndWhenTheirJobIsDismissedAndLeaveTheWorkersFree) {
  const auto submitted = served_.submit("simulate-plan", flights(10'000));
  ASSERT_EQ(submitted.status, 201) << submitted.body;
  const std::string job = submitted.json().at("jobID");
  ASSERT_TRUE(wait_until([&] { return status_of(job) == "running"; }));

  const auto dismissed = served_.remove("/jobs/" + job);

  EXPECT_EQ(dismissed.status, 200) << dismissed.body;
  EXPECT_NE(status_of(job), "running");
  EXPECT_EQ(served_.execute("simulate-plan", flights(1)).status, 200);
}

TEST(ScenarioOverHttp, IsFlownAsByTheCommandLine) {
  const support::Program program;
  const support::ServedProgram served{program.folder() / "store", {"--workers", "2"}};

  const auto flown =
      served.execute("fly-scenario", {{"scenario", "random-icebergs"}, {"runs", 2}, {"seed", 9}});
  const auto refused = served.execute("fly-scenario", {{"scenario", "calm"}, {"runs", 0}});
  json told =
      program.run({"simulate", "--scenario", "random-icebergs", "--runs", "2", "--seed", "9", "--json"})
          .json();

  ASSERT_EQ(flown.status, 200) << flown.body;
  told.erase("real_time_factor");
  EXPECT_EQ(flown.json().at("scenario"), told);
  EXPECT_EQ(told.at("flights").size(), 2U);
  EXPECT_EQ(refused.status, 400);
  EXPECT_THAT(refused.body, HasSubstr("/scenario"));
  EXPECT_THAT(refused.body, HasSubstr("/runs"));
}

TEST(FlightComparisonOverHttp, IsMadeAsByTheCommandLine) {
  const auto log = support::shared_sample("glider/slocum_comet-2019-222-02-154_nav.csv");
  if (!std::filesystem::exists(log)) GTEST_SKIP() << "the shared logs are not there";
  const support::Program program;
  const support::ServedProgram served{program.folder() / "store"};
  std::ostringstream text;
  text << std::ifstream{log}.rdbuf();

  const auto compared =
      served.execute("compare-flight", {{"files", {{{"name", log.string()}, {"text", text.str()}}}}});

  ASSERT_EQ(compared.status, 200) << compared.body;
  EXPECT_EQ(compared.json().at("comparison"), program.run({"compare-flight", log.string(), "--json"}).json());
}

TEST(FlightComparisonOverHttp, NamesWhatIsWrongWithALog) {
  const support::Program program;
  const support::ServedProgram served{program.folder() / "store"};
  const std::string text = "m_present_time,m_depth\ntimestamp,m\n1,deep\n";

  const auto refused = served.execute(
      "compare-flight",
      {{"files", {{{"name", "log.csv"}, {"text", text}}}}, {"vehicle", "boat"}, {"drag", "sea"}});

  EXPECT_EQ(refused.status, 400);
  EXPECT_THAT(refused.body, HasSubstr("/files/0/line 3/m_depth"));
  EXPECT_THAT(refused.body, HasSubstr("slocum-g3-200"));
  EXPECT_THAT(refused.body, HasSubstr("/drag"));
}

}  // namespace
}  // namespace floeplan::cli::simulations_over_http_test

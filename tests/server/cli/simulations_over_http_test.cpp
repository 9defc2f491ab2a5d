#include <gtest/gtest.h>

#include "tests/server/cli/program.hpp"
#include "tests/server/cli/served_program.hpp"
#include "tests/server/jobs/wait_until.hpp"

namespace floeplan::cli {
namespace {

using nlohmann::json;
using support::wait_until;

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

}  // namespace
}  // namespace floeplan::cli

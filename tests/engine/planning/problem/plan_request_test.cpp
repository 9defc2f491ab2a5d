#include "engine/planning/problem/plan_request.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/small_sea.hpp"

namespace floeplan::planning::plan_request_test {
namespace {

std::string fields(const core::Violations& violations) {
  std::string text;
  for (const core::Violation& violation : violations) text += violation.field + ' ';
  return text;
}

TEST(PlanRequest, HasNoViolationsWithItsDefaults) {
  EXPECT_EQ(fields(support::eastward_request().violations()), "");
}

TEST(PlanRequest, NamesEveryFieldThatBreaksARuleAtOnce) {
  PlanRequest request = support::eastward_request();
  request.from = {-53.0, 95.0};
  request.to = {std::nan(""), 69.0};
  request.sectors = 0;
  request.refine_time = core::Seconds{0.01};
  request.max_waypoints = 1;
  request.icebergs.margin = core::Metres{-1.0};
  request.spacing_along = core::Metres{0.0};
  request.vehicle.speed_through_water = core::MetresPerSecond{0.0};

  EXPECT_EQ(fields(request.violations()),
            "/speed_m_s /from /to /sectors /spacing_m /refine_seconds /max_waypoints /margin_m ");
}

TEST(PlanRequest, RefusesAGoalThatIsTheStart) {
  PlanRequest request = support::eastward_request();
  request.to = request.from;
  EXPECT_EQ(fields(request.violations()), "/to ");
}

TEST(PlanRequest, AllowsARoundTripOverAVia) {
  PlanRequest request = support::eastward_request();
  request.via = {request.to};
  request.to = request.from;
  EXPECT_EQ(fields(request.violations()), "");
}

TEST(PlanRequest, RefusesPlacesHalfAnOceanApart) {
  PlanRequest request = support::eastward_request();
  request.to = {100.0, 10.0};
  EXPECT_EQ(fields(request.violations()), "/to ");
}

}  // namespace
}  // namespace floeplan::planning::plan_request_test

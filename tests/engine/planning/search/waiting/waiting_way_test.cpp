#include "engine/planning/search/waiting/waiting_way.hpp"

#include <gtest/gtest.h>

#include "engine/planning/plan_route.hpp"
#include "tests/engine/planning/drifting_bergs.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::search::waiting_way_test {
namespace {

/// Who may not wait turns in circles for hours before a gate, and is through it about when it opens.
TEST(WaitingWay, TurnsInCirclesWhereTheVehicleMayNotWait) {
  PlanRequest request = support::eastward_request();
  request.zones = {
      {.name = "gate",
       .kind = ocean::ZoneKind::no_go,
       .area = {.outer = {{-53.05, 67.6}, {-52.95, 67.6}, {-52.95, 70.4}, {-53.05, 70.4}}, .holes = {}},
       .from = std::nullopt,
       .until = start + core::Seconds{20.0 * hour_s}}};
  request.refine = false;

  const Result<Plan> result = plan_route({}, request, {}, {});

  ASSERT_TRUE(result) << result.error().explanation();
  // The straight way of 39.9 km takes 31.7 h; the gate is 17.9 km, 14.2 h, from the start.
  EXPECT_NEAR(result->travel_time().count() / hour_s, 31.7 + 20.0 - 14.2, 0.5);
}

}  // namespace
}  // namespace floeplan::planning::search::waiting_way_test

#include "engine/planning/planner/strong_currents.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine/messages/sentence.hpp"
#include "engine/planning/cost/layout.hpp"
#include "engine/planning/plan_arrival.hpp"
#include "engine/planning/plan_route.hpp"
#include "engine/planning/plan_window.hpp"
#include "engine/planning/planner/departure.hpp"
#include "engine/planning/planner/strategies.hpp"
#include "engine/planning/search/latest_departure.hpp"
#include "tests/support/done_elsewhere.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::planner::strong_currents_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::Each;
using testing::HasSubstr;
using testing::Not;

constexpr core::Seconds hour{3600.0};

/// A stream that flows southward between start and goal of `across_the_stream`, 16 km wide with banks of 4 km.
ocean::Environment stream(double m_s) {
  ocean::Environment sea;
  sea.currents = support::currents_from(
      [&](geo::LonLat place, double) {
        const bool in_stream = std::abs(place.lon_deg + 52.75) < 0.23;
        return geo::VelocityEn{{0.0}, {in_stream ? -m_s : 0.0}};
      },
      0);
  sea.steady_currents = true;
  return sea;
}

/// 20 km eastwards.
PlanRequest across_the_stream() {
  PlanRequest request = support::eastward_request();
  request.from = {-53.0, 69.0};
  request.to = {-52.5, 69.0};
  return request;
}

TEST(StrongCurrents, CarryAVehicleFurtherThanTheWayIsLongAndLetItComeBack) {
  const ocean::Environment sea = stream(1.0);
  const PlanRequest request = across_the_stream();
  ASSERT_FALSE(try_to_plan(sea, request, {}, {}));

  const auto plan = plan_route(sea, request, {}, {});

  // A vehicle of 0.35 m/s that crosses a current of 1 m/s is carried 2.7 km downstream for each km across.
  ASSERT_TRUE(plan);
  EXPECT_GT(plan->distance.value, 60'000.0);
  EXPECT_THAT(messages::sentences(plan->messages), Contains(HasSubstr("as fast as the vehicle")));
}

TEST(StrongCurrents, AreCrossedByTheBestDepartureOfAWindowAndInTime) {
  const ocean::Environment sea = stream(1.0);
  PlanRequest request = across_the_stream();
  request.refine = false;
  request.departures.until = request.depart + 2.0 * hour;
  request.departures.step = hour;

  EXPECT_TRUE(plan_window(sea, request, {}, {}).plan);

  request.departures = {};
  request.departures.arrive_by = request.depart + 200.0 * hour;
  const auto in_time = plan_arrival(sea, request, {}, {});
  ASSERT_TRUE(in_time);
  EXPECT_GT(in_time->departure, request.depart + hour);
}

TEST(StrongCurrents, AreReadFromAsWideAnAreaAsIsSearched) {
  const ocean::Environment sea = stream(1.0);
  const PlanRequest request = across_the_stream();
  std::vector<geo::BoundingBox> asked;
  const WiderSea wider = [&](const PlanRequest& roomy) {
    asked.push_back(cost::planning_area(roomy));
    return sea;
  };

  ASSERT_TRUE(plan_route(sea, request, {}, {}, wider));

  ASSERT_EQ(asked.size(), 1U);
  EXPECT_TRUE(geo::contains(asked.front(), {-53.0, 69.8}));
  EXPECT_FALSE(geo::contains(cost::planning_area(request), {-53.0, 69.8}));
}

TEST(StrongCurrents, ThatCloseEveryWayAreSaidToBeLookedThroughOnlySoFar) {
  const ocean::Environment sea = stream(6.0);

  const auto plan = plan_route(sea, across_the_stream(), {}, {});

  ASSERT_FALSE(plan);
  EXPECT_EQ(plan.error().reason, Reason::current_too_strong);
  EXPECT_THAT(plan.error().explanation(), HasSubstr("up to 100 km to either side"));
  EXPECT_THAT(plan.error().suggestion(), HasSubstr("--via"));
  EXPECT_THAT(plan.error().suggestion(), Not(HasSubstr("finer grid")));
}

TEST(StrongCurrents, HaveTheBestPlanOfSeveralGridsTaken) {
  const ocean::Environment sea = stream(0.5);
  const PlanRequest request = across_the_stream();
  const auto on_usual_grids = try_to_plan(sea, request, {}, {});
  ASSERT_TRUE(on_usual_grids);

  const auto plan = plan_route(sea, request, {}, {});

  ASSERT_TRUE(plan);
  EXPECT_LE(plan->arrival, on_usual_grids->arrival);
}

TEST(StrongCurrents, GiveTheSamePlanWhereAnotherProcessTriesTheGrids) {
  const PlanRequest request = across_the_stream();
  for (const double m_s : {0.5, 1.0}) {
    const ocean::Environment sea = stream(m_s);
    support::KeptParts kept;

    const auto here = plan_route(sea, request, {}, {}, {}, support::KeepsParts{kept});
    const auto elsewhere = plan_route(sea, request, {}, {}, {}, support::DoneElsewhere{kept});

    EXPECT_FALSE(kept.empty()) << m_s;
    ASSERT_TRUE(here && elsewhere) << m_s;
    EXPECT_EQ(here->arrival, elsewhere->arrival);
    EXPECT_EQ(messages::sentences(here->messages), messages::sentences(elsewhere->messages));
    ASSERT_EQ(here->waypoints.size(), elsewhere->waypoints.size());
    for (std::size_t i = 0; i < here->waypoints.size(); ++i)
      EXPECT_EQ(here->waypoints[i].place, elsewhere->waypoints[i].place);
  }
}

TEST(StrongCurrents, AreACautionOnlyWhereThePlansOfSeveralGridsDiffer) {
  const auto codes = [](const ocean::Environment& sea) {
    const auto plan = plan_route(sea, across_the_stream(), {}, {});
    EXPECT_TRUE(plan);
    std::vector<std::string> found;
    for (const messages::Message& message : plan->messages) found.push_back(message.code);
    return found;
  };
  ocean::Environment fast_elsewhere;
  fast_elsewhere.steady_currents = true;
  fast_elsewhere.currents = support::currents_from(
      [](geo::LonLat place, double) { return geo::VelocityEn{{place.lat_deg > 69.06 ? 1.0 : 0.1}, {0.0}}; },
      1);

  EXPECT_THAT(codes(fast_elsewhere),
              AllOf(Contains("several-grids-agree"), Not(Contains("several-grids-tried"))));
  EXPECT_THAT(codes(stream(1.0)),
              AllOf(Contains("several-grids-tried"), Not(Contains("several-grids-agree"))));
}

TEST(StrongCurrents, AreWhatMakesAllTheDifference) {
  const ocean::Environment sea = stream(0.3);
  const PlanRequest request = across_the_stream();
  const WiderSea wider = [](const PlanRequest&) -> std::optional<ocean::Environment> {
    ADD_FAILURE() << "no currents are as fast as the vehicle";
    return std::nullopt;
  };

  const auto plan = plan_route(sea, request, {}, {}, wider);

  const auto on_usual_grids = try_to_plan(sea, request, {}, {});
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->arrival, on_usual_grids->arrival);
  EXPECT_EQ(plan->waypoints.size(), on_usual_grids->waypoints.size());
  EXPECT_THAT(messages::sentences(plan->messages), Each(Not(HasSubstr("as fast as the vehicle"))));
}

TEST(StrongCurrents, HaveRoomOfFiveTimesTheDistanceOnAGridOfUsualSize) {
  const ocean::Environment sea = stream(1.0);
  const PlanRequest request = across_the_stream();

  const auto roomy = with_more_room(sea, request, {});

  ASSERT_TRUE(roomy);
  EXPECT_NEAR(roomy->request.room->value, 5.0 * 20'000.0, 1500.0);
  EXPECT_LT(cost::lay_out(roomy->request, cost::reaches(roomy->request).back()).most_vertices(), 250'000.0);
}

}  // namespace
}  // namespace floeplan::planning::planner::strong_currents_test

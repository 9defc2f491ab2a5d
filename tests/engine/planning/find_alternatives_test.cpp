#include "engine/planning/find_alternatives.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <vector>

#include "engine/messages/sentence.hpp"
#include "engine/planning/plan_route.hpp"
#include "tests/support/backwards.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::find_alternatives_test {
namespace {

using support::eastward_request;
using testing::AllOf;
using testing::Gt;
using testing::HasSubstr;
using testing::Lt;
using testing::SizeIs;

PlanRequest asking_for(int alternatives) {
  PlanRequest request = eastward_request();
  request.alternatives = alternatives;
  return request;
}

/// Land or water of this depth in boxes, and 500 m elsewhere.
struct Box {
  double west, south, east, north, depth_m;
};

ocean::Environment sea_with(std::vector<Box> boxes) {
  return {.bathymetry = support::bathymetry_from([boxes](geo::LonLat place) {
            for (const Box& box : boxes) {
              if (place.lon_deg >= box.west && place.lon_deg <= box.east && place.lat_deg >= box.south &&
                  place.lat_deg <= box.north)
                return box.depth_m;
            }
            return 500.0;
          })};
}

// Their borders lie on the nodes of the sea, 0.1 x 0.05 degrees, so the banks end within a node of them.
/// More of it lies north of the straight route, so the best route passes south.
constexpr Box bank{-53.11, 68.94, -52.89, 69.11, 15.0};
/// North of the first, with a gap between them.
constexpr Box second_bank{-53.11, 69.19, -52.89, 69.26, 15.0};

Plan best(const ocean::Environment& sea, const PlanRequest& request) {
  Result<Plan> plan = plan_route(sea, request, {}, {});
  EXPECT_TRUE(plan.has_value());
  return plan ? std::move(*plan) : Plan{};
}

Alternatives alternatives(const ocean::Environment& sea, const PlanRequest& request,
                          const core::Executor& executor = core::in_order()) {
  Result<Alternatives> found = find_alternatives(sea, request, best(sea, request), {}, {}, executor);
  EXPECT_TRUE(found.has_value());
  return found ? std::move(*found) : Alternatives{};
}

/// The latitude of the route at this longitude.
double latitude_at(const Plan& plan, double lon_deg) {
  for (std::size_t i = 1; i < plan.waypoints.size(); ++i) {
    const geo::LonLat a = plan.waypoints[i - 1].place;
    const geo::LonLat b = plan.waypoints[i].place;
    if (a.lon_deg <= lon_deg && lon_deg <= b.lon_deg)
      return std::lerp(a.lat_deg, b.lat_deg, (lon_deg - a.lon_deg) / (b.lon_deg - a.lon_deg));
  }
  return NAN;
}

TEST(FindAlternatives, PassABankOnItsOtherSide) {
  const ocean::Environment sea = sea_with({bank});
  const PlanRequest request = asking_for(2);
  ASSERT_LT(latitude_at(best(sea, request), -53.0), 68.95);

  const Alternatives found = alternatives(sea, request);

  ASSERT_THAT(found.found, SizeIs(1));
  EXPECT_GT(latitude_at(found.found[0].plan, -53.0), 69.1);
  const std::string reason = messages::sentence(found.found[0].reason);
  EXPECT_THAT(reason, HasSubstr("north of the shallow water"));
  const auto place = found.found[0].reason.place;
  ASSERT_TRUE(place);
  EXPECT_THAT(place->lon_deg, AllOf(Gt(bank.west), Lt(bank.east)));
  EXPECT_THAT(place->lat_deg, AllOf(Gt(bank.south), Lt(bank.north)));
  ASSERT_TRUE(found.fewer);
}

TEST(FindAlternatives, SayTheDifferenceOfTheTravelTimesToTheMinute) {
  for (const double south : {68.90, 68.92, 68.94, 68.95}) {
    const ocean::Environment sea = sea_with({{-53.11, south, -52.89, 69.06, 15.0}});
    const auto found = alternatives(sea, asking_for(1)).found;
    ASSERT_THAT(found, SizeIs(1));
    const long minutes = std::lround(
        (found.front().plan.travel_time() - best(sea, asking_for(1)).travel_time()).count() / 60.0);
    const std::string told = minutes == 0 ? "the same time"
                             : minutes < 60
                                 ? std::to_string(minutes) + " min more"
                                 : std::to_string(minutes / 60) + " h " + (minutes % 60 < 10 ? "0" : "") +
                                       std::to_string(minutes % 60) + " min more";
    EXPECT_THAT(found.front().reason.text, testing::EndsWith("This route takes " + told)) << south;
  }
}

/// The search for the plan may end in a worse route than the search round an obstacle, as both are limited to their grids.
/// Here the plan that is given is such a route.
TEST(FindAlternatives, CostNoLessThanTheBestPlanWhoseRankACheaperOneTakes) {
  const ocean::Environment sea = sea_with({bank});
  const PlanRequest request = asking_for(1);
  const Plan south = best(sea, request);
  const Plan north = alternatives(sea, request).found.at(0).plan;

  const Result<Alternatives> found = find_alternatives(sea, request, north, {}, {});

  ASSERT_TRUE(found.has_value());
  ASSERT_TRUE(found->better);
  EXPECT_NEAR(found->better->travel_time().count(), south.travel_time().count(), 60.0);
  EXPECT_LT(latitude_at(*found->better, -53.0), 68.95);
  ASSERT_THAT(found->found, SizeIs(1));
  EXPECT_EQ(found->found[0].plan.travel_time(), north.travel_time());
  EXPECT_TRUE(found->found[0].request.zones.empty());
  EXPECT_THAT(messages::sentence(found->found[0].reason), HasSubstr("min more"));
  EXPECT_FALSE(alternatives(sea, request).better);
}

TEST(FindAlternatives, AreThePlansOfTheirOwnRequests) {
  const ocean::Environment sea = sea_with({bank});
  const Alternatives found = alternatives(sea, asking_for(1));
  ASSERT_THAT(found.found, SizeIs(1));

  const Plan again = best(sea, found.found[0].request);

  ASSERT_THAT(again.waypoints, SizeIs(found.found[0].plan.waypoints.size()));
  for (std::size_t i = 0; i < again.waypoints.size(); ++i) {
    EXPECT_EQ(again.waypoints[i].place, found.found[0].plan.waypoints[i].place);
    EXPECT_EQ(again.waypoints[i].eta, found.found[0].plan.waypoints[i].eta);
  }
}

TEST(FindAlternatives, PassBetweenTwoBanksAndBeyondTheSecond) {
  // South of both is best, the gap between them next, north of both last.
  const ocean::Environment sea = sea_with({bank, second_bank});
  const Alternatives found = alternatives(sea, asking_for(3));

  ASSERT_THAT(found.found, SizeIs(2));
  const double first = latitude_at(found.found[0].plan, -53.0);
  EXPECT_GT(first, 69.1);
  EXPECT_LT(first, 69.2);
  EXPECT_GT(latitude_at(found.found[1].plan, -53.0), 69.25);
  EXPECT_LE(found.found[0].plan.travel_time(), found.found[1].plan.travel_time());
}

TEST(FindAlternatives, GoRoundAGroupOfIcebergsAndNotThroughIt) {
  ocean::Environment sea;
  for (const double lon_deg : {-53.04, -53.01, -52.98})
    for (const double lat_deg : {68.99, 69.0, 69.01, 69.02, 69.03, 69.04})
      sea.icebergs.push_back(support::iceberg_at({lon_deg, lat_deg}, 300.0));
  PlanRequest request = asking_for(1);
  request.icebergs.drift = false;

  const Alternatives found = alternatives(sea, request);

  ASSERT_THAT(found.found, SizeIs(1));
  EXPECT_GT(latitude_at(found.found[0].plan, -53.01), 69.04);
  EXPECT_THAT(messages::sentence(found.found[0].reason), HasSubstr("north of the icebergs"));
}

TEST(FindAlternatives, SayWhenThereIsNothingToGoRound) {
  const Alternatives found = alternatives({}, asking_for(2));

  EXPECT_THAT(found.found, SizeIs(0));
  ASSERT_TRUE(found.fewer);
  EXPECT_EQ(found.fewer->code, "nothing-to-go-round");
}

TEST(FindAlternatives, TakeNoMoreThanTwiceTheTime) {
  // A bank to the north with arms at its end: 95 km round it in place of 40 km.
  const ocean::Environment sea =
      sea_with({{-53.01, 68.99, -52.99, 69.31, 15.0}, {-53.31, 69.29, -52.69, 69.31, 15.0}});
  const Alternatives found = alternatives(sea, asking_for(1));

  EXPECT_THAT(found.found, SizeIs(0));
  ASSERT_TRUE(found.fewer);
  EXPECT_EQ(found.fewer->code, "few-alternatives");
}

TEST(FindAlternatives, AreTheSameOnSeveralThreads) {
  const ocean::Environment sea = sea_with({bank, second_bank});
  const Alternatives in_order = alternatives(sea, asking_for(2));
  const Alternatives backwards = alternatives(sea, asking_for(2), support::Backwards{});

  ASSERT_EQ(in_order.found.size(), backwards.found.size());
  for (std::size_t i = 0; i < in_order.found.size(); ++i) {
    EXPECT_EQ(in_order.found[i].plan.arrival, backwards.found[i].plan.arrival);
    EXPECT_EQ(in_order.found[i].plan.waypoints.size(), backwards.found[i].plan.waypoints.size());
  }
}

TEST(FindAlternatives, EndWhenTheyAreStopped) {
  const ocean::Environment sea = sea_with({bank});
  const PlanRequest request = asking_for(1);
  const Plan plan = best(sea, request);
  std::stop_source stop;
  stop.request_stop();

  const auto found = find_alternatives(sea, request, plan, stop.get_token(), {});

  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().reason, Reason::cancelled);
}

TEST(FindAlternatives, AreForASingleDepartureAndASearch) {
  PlanRequest window = asking_for(1);
  window.departures.until = window.depart + std::chrono::hours{6};
  window.departures.step = std::chrono::hours{1};
  PlanRequest straight = asking_for(1);
  straight.method = Method::direct;

  for (const PlanRequest& request : {window, straight}) {
    ASSERT_THAT(request.violations(), SizeIs(1));
    EXPECT_EQ(request.violations()[0].field, "/alternatives");
  }
}

}  // namespace
}  // namespace floeplan::planning::find_alternatives_test

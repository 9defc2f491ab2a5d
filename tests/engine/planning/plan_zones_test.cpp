#include <gtest/gtest.h>

#include <cmath>

#include "engine/geo/geodesic.hpp"
#include "engine/messages/sentence.hpp"
#include "engine/planning/plan_route.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::plan_zones_test {
namespace {

using ocean::Zone;
using ocean::ZoneKind;
using support::eastward_request;

geo::Polygon box(double west, double south, double east, double north) {
  return {.outer = {{west, south}, {east, south}, {east, north}, {west, north}}, .holes = {}};
}

Zone no_go(geo::Polygon area) {
  return {.name = "", .kind = ZoneKind::no_go, .area = std::move(area), .from = {}, .until = {}};
}
Zone stay_in(geo::Polygon area) {
  return {.name = "", .kind = ZoneKind::stay_in, .area = std::move(area), .from = {}, .until = {}};
}

Result<Plan> plan(const PlanRequest& request, const ocean::Environment& environment = {}) {
  return plan_route(environment, request, {}, {});
}

/// Whether any of many points on the plan's legs lies in the area, and not close to its border.
bool enters(const Plan& found, const geo::Polygon& area) {
  for (std::size_t i = 1; i < found.waypoints.size(); ++i) {
    const geo::LonLat a = found.waypoints[i - 1].place;
    const geo::LonLat b = found.waypoints[i].place;
    for (int k = 0; k <= 400; ++k) {
      const double share = k / 400.0;
      const geo::LonLat here{a.lon_deg + share * (b.lon_deg - a.lon_deg),
                             a.lat_deg + share * (b.lat_deg - a.lat_deg)};
      if (geo::contains(area, here)) return true;
    }
  }
  return false;
}

/// A wall across the straight route with its ends well inside the grid.
geo::Polygon wall(const PlanRequest& request) {
  const double middle = 0.5 * (request.from.lon_deg + request.to.lon_deg);
  return box(middle - 0.02, request.from.lat_deg - 0.05, middle + 0.02, request.from.lat_deg + 0.09);
}

TEST(PlanZones, GoRoundAnAreaThatIsClosed) {
  PlanRequest request = eastward_request();
  const auto straight = plan(request);
  const geo::Polygon closed = wall(request);
  request.zones = {no_go(closed)};

  const auto found = plan(request);

  ASSERT_TRUE(straight && found);
  EXPECT_TRUE(enters(*straight, closed));
  EXPECT_FALSE(enters(*found, closed));
  EXPECT_GT(found->arrival, straight->arrival);
}

/// The plan's warning of areas that it passes with little time to spare; empty: there is none.
std::string warning_of_time(const Plan& found) {
  for (const std::string& warning : messages::sentences(found.messages))
    if (warning.find("break the rule of the area") != std::string::npos) return warning;
  return "";
}

TEST(PlanZones, WarnWhereAVehicleThatIsAFewPercentFasterOrSlowerBreaksTheirRule) {
  PlanRequest request = eastward_request();
  request.refine = false;
  const auto straight = plan(request);
  ASSERT_TRUE(straight);
  const double middle = 0.5 * (request.from.lon_deg + request.to.lon_deg);
  const core::Seconds half = 0.5 * straight->travel_time();
  const auto passing = [&](std::optional<double> from, std::optional<double> until) {
    Zone line =
        no_go(box(middle - 0.003, request.from.lat_deg - 0.2, middle + 0.003, request.from.lat_deg + 0.2));
    if (from) line.from = request.depart + *from * half;
    if (until) line.until = request.depart + *until * half;
    PlanRequest past = request;
    past.zones = {line};
    return warning_of_time(plan(past).value());
  };

  EXPECT_NE(passing({}, 0.97).find("after an area there reopens"), std::string::npos) << passing({}, 0.97);
  EXPECT_EQ(passing({}, 0.9), "");
  EXPECT_NE(passing(1.03, {}).find("before an area there closes"), std::string::npos) << passing(1.03, {});
  EXPECT_EQ(passing(1.1, {}), "");
}

TEST(PlanZones, GoRoundAnAreaThatIsLongBesideTheWay) {
  PlanRequest request = eastward_request();
  request.to = {request.from.lon_deg + 0.17, request.from.lat_deg};  // 7 km
  const double middle = request.from.lon_deg + 0.085;
  request.zones = {
      no_go(box(middle - 0.02, request.from.lat_deg - 0.1, middle + 0.02, request.from.lat_deg + 0.11))};

  const auto found = plan(request);

  ASSERT_TRUE(found.has_value()) << found.error().explanation();
  EXPECT_GT(found->distance.value, 22'000.0);
}

TEST(PlanZones, ObeyZonesOfTheEnvironmentAsThoseOfTheRequest) {
  PlanRequest request = eastward_request();
  const Zone closed = no_go(wall(request));
  ocean::Environment environment;
  environment.zones = {closed};

  const auto by_environment = plan(request, environment);
  request.zones = {closed};
  const auto by_request = plan(request);

  ASSERT_TRUE(by_environment && by_request);
  EXPECT_EQ(by_environment->arrival, by_request->arrival);
}

TEST(PlanZones, PassUnderAnAreaThatIsClosedOnlyBelowTheDive) {
  PlanRequest request = eastward_request();
  const auto straight = plan(request);
  Zone deep = no_go(wall(request));
  deep.top = core::Metres{request.vehicle.dive_depth.value + 1.0};
  request.zones = {deep};

  const auto found = plan(request);

  ASSERT_TRUE(straight && found);
  EXPECT_EQ(found->arrival, straight->arrival);
}

TEST(PlanZones, CrossAnAreaOutsideItsTimeAndGoRoundItWithin) {
  PlanRequest request = eastward_request();
  const auto straight = plan(request);
  ASSERT_TRUE(straight.has_value());
  Zone timed = no_go(wall(request));

  timed.from = request.depart;
  timed.until = straight->arrival;
  request.zones = {timed};
  const auto while_closed = plan(request);

  timed.from = straight->arrival;
  timed.until.reset();
  request.zones = {timed};
  const auto before_it_closes = plan(request);

  ASSERT_TRUE(while_closed && before_it_closes);
  EXPECT_FALSE(enters(*while_closed, timed.area));
  EXPECT_EQ(before_it_closes->arrival, straight->arrival);
}

TEST(PlanZones, KeepTheWayInsideAnAreaToStayIn) {
  PlanRequest request = eastward_request();
  const double middle = 0.5 * (request.from.lon_deg + request.to.lon_deg);
  // A horseshoe: up from the start, across, and down to the goal.
  const double south = request.from.lat_deg - 0.02;
  const double north = request.from.lat_deg + 0.12;
  geo::Polygon horseshoe = box(request.from.lon_deg - 0.1, south, request.to.lon_deg + 0.1, north);
  horseshoe.holes = {{{middle - 0.05, south},
                      {middle + 0.05, south},
                      {middle + 0.05, north - 0.05},
                      {middle - 0.05, north - 0.05}}};
  request.zones = {stay_in(horseshoe)};

  const auto found = plan(request);

  ASSERT_TRUE(found.has_value());
  for (const Waypoint& waypoint : found->waypoints) EXPECT_TRUE(geo::contains(horseshoe, waypoint.place));
  EXPECT_FALSE(enters(*found, {.outer = horseshoe.holes.front(), .holes = {}}));
}

TEST(PlanZones, CrossTheEdgeThatTwoAreasToStayInShareAlwaysAsForAWhile) {
  PlanRequest request = eastward_request();
  const double middle = 0.5 * (request.from.lon_deg + request.to.lon_deg);
  const auto stay_in_two = [&](double gap_deg) {
    request.zones = {stay_in(box(request.from.lon_deg - 0.1, 68.9, middle, 69.1)),
                     stay_in(box(middle + gap_deg, 68.9, request.to.lon_deg + 0.1, 69.1))};
  };

  stay_in_two(0.0);
  const auto always = plan(request);
  for (Zone& zone : request.zones) zone.until = request.depart + core::Seconds{1e6};
  const auto for_a_while = plan(request);
  stay_in_two(0.0002);  // 8 m
  const auto past_a_gap = plan(request);

  ASSERT_TRUE(always && for_a_while);
  EXPECT_EQ(always->arrival, for_a_while->arrival);
  EXPECT_FALSE(past_a_gap.has_value());
}

TEST(PlanZones, RefuseAStartThatIsNotAllowedAndSayWhere) {
  PlanRequest request = eastward_request();
  request.zones = {no_go(box(request.from.lon_deg - 0.01, request.from.lat_deg - 0.01,
                             request.from.lon_deg + 0.01, request.from.lat_deg + 0.01))};
  const auto in_closed_area = plan(request);

  request.zones = {stay_in(box(request.from.lon_deg - 0.3, request.from.lat_deg - 0.1,
                               request.to.lon_deg - 0.05, request.to.lat_deg + 0.1))};
  const auto goal_outside = plan(request);

  request.zones.front().from = request.depart;
  request.zones.front().area = box(10.0, 10.0, 11.0, 11.0);
  const auto start_outside_now = plan(request);

  ASSERT_FALSE(in_closed_area || goal_outside || start_outside_now);
  EXPECT_EQ(in_closed_area.error().reason, Reason::start_in_zone);
  EXPECT_EQ(goal_outside.error().reason, Reason::goal_in_zone);
  EXPECT_EQ(start_outside_now.error().reason, Reason::start_in_zone);
}

TEST(PlanZones, LeaveNoRoomInAnAreaToStayInThatIsTooShallowForTheDive) {
  PlanRequest request = eastward_request();
  Zone shallow = stay_in(box(-56.0, 67.5, -50.0, 70.5));
  shallow.bottom = core::Metres{request.vehicle.dive_depth.value - 1.0};
  request.zones = {shallow};

  const auto found = plan(request);

  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().reason, Reason::start_in_zone);
}

TEST(PlanZones, AreNamedWithEveryFault) {
  PlanRequest request = eastward_request();
  Zone broken = no_go({.outer = {{0.0, 0.0}, {1.0, 95.0}}, .holes = {}});
  broken.from = request.depart;
  broken.until = request.depart - core::Seconds{1.0};
  broken.top = core::Metres{30.0};
  broken.bottom = core::Metres{20.0};
  request.zones = {no_go(box(0.0, 0.0, 1.0, 1.0)), broken};

  const core::Violations found = request.violations();

  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].field, "/zones/1/area");
  EXPECT_EQ(found[1].field, "/zones/1/until");
  EXPECT_EQ(found[2].field, "/zones/1/bottom_m");
}

TEST(PlanLegs, AreNoLongerThanAskedForAndTheWayStaysTheSame) {
  PlanRequest request = eastward_request();
  const auto whole = plan(request);
  request.max_leg = core::Metres{3000.0};

  const auto parted = plan(request);

  ASSERT_TRUE(whole && parted);
  for (std::size_t i = 1; i < parted->waypoints.size(); ++i) {
    EXPECT_LE(parted->waypoints[i].leg_length->value, 3000.0 * (1.0 + 1e-6));
  }
  EXPECT_NEAR(parted->travel_time().count(), whole->travel_time().count(),
              1e-4 * whole->travel_time().count());
  EXPECT_EQ(parted->waypoints.size(),
            static_cast<std::size_t>(std::ceil(whole->distance.value / 3000.0)) + 1);
}

/// The area between a parallel and a pole. Its outline follows the parallel round the Earth and returns along the pole.
geo::Polygon cap(double lat_deg) {
  geo::Polygon area;
  for (int lon_deg = -180; lon_deg <= 180; lon_deg += 60)
    area.outer.push_back({geo::wrap_longitude(lon_deg), lat_deg});
  for (int lon_deg = 180; lon_deg >= -180; lon_deg -= 60)
    area.outer.push_back({geo::wrap_longitude(lon_deg), std::copysign(90.0, lat_deg)});
  return area;
}

TEST(PlanZones, MayBeAllTheSeaRoundAPole) {
  for (const double hemisphere : {1.0, -1.0}) {
    PlanRequest request = eastward_request();
    request.from.lat_deg *= hemisphere;
    request.to.lat_deg *= hemisphere;
    const auto with = [&](Zone zone) {
      request.zones = {std::move(zone)};
      return plan(request).has_value();
    };

    EXPECT_FALSE(with(no_go(cap(60.0 * hemisphere))));
    EXPECT_TRUE(with(no_go(cap(-60.0 * hemisphere))));
    EXPECT_TRUE(with(stay_in(cap(60.0 * hemisphere))));
    EXPECT_FALSE(with(stay_in(cap(-60.0 * hemisphere))));
  }
}

TEST(PlanZones, MayReachFarBeyondWhatThePlaneShows) {
  PlanRequest request = eastward_request();
  for (const double lat_deg : {0.5, 40.0, 69.0}) {
    request.from = {-53.5, lat_deg};
    request.to = {-52.5, lat_deg};
    // A quarter round the Earth from the start, and the other side of it.
    request.zones = {no_go({.outer = {{-120.0, -80.0},
                                      {-53.0, -60.0},
                                      {30.0, -80.0},
                                      {37.0, 80.0},
                                      {20.0, -70.0},
                                      {-53.0, -50.0}},
                            .holes = {}}),
                     no_go(box(100.0, -70.0, 150.0, 88.0))};

    EXPECT_TRUE(plan(request)) << lat_deg;
  }
}

/// The zone never reopens, so the refusal names no time, although an iceberg over the goal leaves it.
TEST(PlanZones, ThatHoldForEverAreNotSaidToOpenWhenAnIcebergIsGone) {
  PlanRequest request = eastward_request();
  request.zones = {stay_in(box(-53.6, 68.9, -52.8, 69.1))};
  ocean::Environment environment;
  environment.icebergs = {support::iceberg_at(request.to, 100.0)};
  environment.icebergs[0].earlier = {{{-52.6, 69.0}, request.depart - core::Seconds{12.0 * 3600.0}}};

  const auto found = plan(request, environment);

  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().reason, Reason::goal_in_zone);
  EXPECT_EQ(found.error().explanation().find("until"), std::string::npos) << found.error().explanation();
}

}  // namespace
}  // namespace floeplan::planning::plan_zones_test

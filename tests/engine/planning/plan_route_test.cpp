#include "engine/planning/plan_route.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "engine/geo/geodesic.hpp"
#include "engine/messages/sentence.hpp"
#include "engine/planning/cost/layout.hpp"
#include "engine/planning/evaluate_route.hpp"
#include "engine/planning/plane/coast_lines.hpp"
#include "engine/planning/plane/plane_lines.hpp"
#include "engine/planning/planner/strategies.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::plan_route_test {
namespace {

using support::bathymetry_from;
using support::currents_from;
using support::eastward_request;

Result<Plan> plan(const ocean::Environment& environment, const PlanRequest& request) {
  return plan_route(environment, request, {}, {});
}

geo::VelocityEn tide(geo::LonLat place, double hour) {
  const double phase = 2.0 * 3.14159265358979 * hour / 12.42;
  return {{0.15 * std::cos(phase)}, {0.2 * std::sin(phase + place.lon_deg)}};
}

TEST(PlanRoute, GoesStraightInStillWater) {
  const PlanRequest request = eastward_request();

  const auto found = plan({}, request);

  ASSERT_TRUE(found.has_value());
  const double distance_m = geo::geodesic_between(request.from, request.to).length.value;
  EXPECT_EQ(found->waypoints.size(), 2U);
  EXPECT_NEAR(found->travel_time().count(), distance_m / 0.35, 1e-4 * distance_m / 0.35);
  EXPECT_NEAR(found->distance.value, distance_m, 1e-6 * distance_m);
}

TEST(PlanRoute, BeginsAndEndsWhereItWasAskedTo) {
  const PlanRequest request = eastward_request();

  const auto found = plan({.currents = currents_from(tide, 72)}, request);

  ASSERT_TRUE(found.has_value());
  EXPECT_LT(geo::geodesic_between(found->waypoints.front().place, request.from).length.value, 0.01);
  EXPECT_LT(geo::geodesic_between(found->waypoints.back().place, request.to).length.value, 0.01);
  EXPECT_EQ(found->waypoints.front().eta, request.depart);
  EXPECT_EQ(found->waypoints.back().eta, found->arrival);
}

TEST(PlanRoute, TakesTheSameTimeByEveryExactSearch) {
  PlanRequest request = eastward_request();
  request.refine = false;
  const ocean::Environment environment{.currents = currents_from(tide, 72)};

  request.method = Method::astar;
  const auto astar = plan(environment, request);
  request.method = Method::dijkstra;
  const auto dijkstra = plan(environment, request);
  request.method = Method::tve;
  const auto tve = plan(environment, request);

  ASSERT_TRUE(astar && dijkstra && tve);
  EXPECT_NEAR(astar->travel_time().count(), tve->travel_time().count(), 1e-6);
  EXPECT_NEAR(dijkstra->travel_time().count(), tve->travel_time().count(), 1e-6);
  EXPECT_LE(astar->search.expansions, dijkstra->search.expansions);
  EXPECT_EQ(tve->search.reinsertions, 0);
}

TEST(PlanRoute, IsNeverSlowerThanTheStraightLineOrTheFrozenSearch) {
  PlanRequest request = eastward_request();
  request.leg_tolerance = 0.0;  // nothing is given for fewer legs
  const ocean::Environment environment{.currents = currents_from(tide, 96)};
  const auto best = plan(environment, request);
  ASSERT_TRUE(best.has_value());

  for (const Method method : {Method::direct, Method::frozen}) {
    request.method = method;
    const auto other = plan(environment, request);
    if (other.has_value()) {
      EXPECT_LE(best->travel_time(), other->travel_time() * (1.0 + 2e-4));
    }
  }
}

TEST(PlanRoute, HasTheTimeThatEvaluatingItGives) {
  const PlanRequest request = eastward_request();
  const ocean::Environment environment{.currents = currents_from(tide, 72)};
  const auto found = plan(environment, request);
  ASSERT_TRUE(found.has_value());
  std::vector<geo::LonLat> route;
  for (const Waypoint& waypoint : found->waypoints) route.push_back(waypoint.place);

  const auto evaluated = evaluate_route(environment, route, request);

  ASSERT_TRUE(evaluated.has_value());
  EXPECT_NEAR(evaluated->travel_time().count(), found->travel_time().count(),
              1e-4 * found->travel_time().count());
}

TEST(PlanRoute, GivesTheSameBytesForTheSameInput) {
  const PlanRequest request = eastward_request();
  const ocean::Environment environment{.currents = currents_from(tide, 72)};

  const auto first = plan(environment, request);
  const auto second = plan(environment, request);

  ASSERT_TRUE(first && second);
  ASSERT_EQ(first->waypoints.size(), second->waypoints.size());
  for (std::size_t i = 0; i < first->waypoints.size(); ++i) {
    EXPECT_EQ(first->waypoints[i].place, second->waypoints[i].place);
    EXPECT_EQ(first->waypoints[i].eta, second->waypoints[i].eta);
  }
}

TEST(PlanRoute, PassesAnIcebergOutsideItsMargin) {
  PlanRequest request = eastward_request();
  request.icebergs.margin = core::Metres{2000.0};
  ocean::Environment environment;
  environment.icebergs = {support::iceberg_at({-53.0, 69.0}, 400.0)};

  const auto found = plan(environment, request);

  ASSERT_TRUE(found.has_value());
  EXPECT_GT(found->waypoints.size(), 2U);
  EXPECT_GE(found->clearances.iceberg.value().value, 2000.0);
}

TEST(PlanRoute, GoesRoundAShoalThatTheStraightLineCrosses) {
  PlanRequest request = eastward_request();
  const ocean::Environment environment{.bathymetry = bathymetry_from([](geo::LonLat place) {
                                         const bool shoal =
                                             std::abs(place.lon_deg + 53.0) < 0.15 && place.lat_deg < 69.1;
                                         return shoal ? 5.0 : 300.0;
                                       })};

  const auto found = plan(environment, request);
  request.method = Method::direct;
  const auto straight = plan(environment, request);

  ASSERT_TRUE(found.has_value());
  EXPECT_GE(found->clearances.bottom.value().value, 10.0 - 1e-9);
  ASSERT_FALSE(straight.has_value());
  EXPECT_EQ(straight.error().reason, Reason::too_shallow);
}

TEST(PlanRoute, MeasuresItsDistanceFromTheSidesOfAnIslandNotItsCorners) {
  ocean::Environment environment;
  environment.land = {{.outer = {{-54.5, 69.1}, {-51.5, 69.1}, {-53.0, 69.4}}, .holes = {}}};
  PlanRequest request = eastward_request();
  request.method = Method::direct;

  const auto found = plan(environment, request);

  ASSERT_TRUE(found.has_value());
  const double to_the_south_side_m = geo::geodesic_between({-53.5, 69.0}, {-53.5, 69.1}).length.value;
  EXPECT_NEAR(found->clearances.land.value().value, to_the_south_side_m, 0.02 * to_the_south_side_m);
}

TEST(PlanRoute, MeasuresItsDistanceFromACoastHoweverFarAway) {
  for (const double south_deg : {69.02, 69.3, 72.0, 80.0, -60.0}) {
    ocean::Environment environment;
    environment.land = {
        {.outer = {{-120.0, 84.0}, {-119.0, 84.0}, {-119.0, 85.0}}, .holes = {}},
        {.outer = {{-54.0, south_deg}, {-52.0, south_deg}, {-53.0, south_deg + 2.0}}, .holes = {}}};
    PlanRequest request = eastward_request();
    request.method = Method::direct;

    const auto found = plan(environment, request);

    ASSERT_TRUE(found.has_value());
    const geo::LocalProjection projection = cost::lay_out(request, cost::first_reach).projection;
    const geo::PlanePoint from = projection.to_plane(request.from);
    const geo::PlanePoint to = projection.to_plane(request.to);
    double least_m = INFINITY;
    for (const geo::Polygon& land : environment.land) {
      plane::for_each_coast_line(land.outer, projection, [&](geo::PlanePoint a, geo::PlanePoint b) {
        for (double share = 0.0; share <= 1.0; share += 1.0 / 1024.0) {
          const geo::PlanePoint at{from.x_m + share * (to.x_m - from.x_m),
                                   from.y_m + share * (to.y_m - from.y_m)};
          least_m = std::min(least_m, plane::distance_to_line(at, a, b));
        }
      });
    }
    EXPECT_NEAR(found->clearances.land.value().value, least_m, 10.0 + 1e-4 * least_m) << south_deg;
  }
}

TEST(PlanRoute, WarnsWhereItPassesLandCloserThanItsPositionError) {
  PlanRequest request = eastward_request();
  request.method = Method::direct;
  request.under_ice.surfacing_interval = core::Seconds{6.0 * 3600.0};  // an error of 1.5 km
  const geo::LocalProjection projection = cost::lay_out(request, cost::first_reach).projection;
  const geo::PlanePoint from = projection.to_plane(request.from);
  const geo::PlanePoint to = projection.to_plane(request.to);
  const auto warns_of_island = [&](double away_m) {
    const geo::LonLat south =
        projection.to_lon_lat({0.5 * (from.x_m + to.x_m), 0.5 * (from.y_m + to.y_m) + away_m});
    ocean::Environment environment;
    environment.land = {{.outer = {south,
                                   {south.lon_deg + 0.01, south.lat_deg + 0.01},
                                   {south.lon_deg - 0.01, south.lat_deg + 0.01}},
                         .holes = {}}};
    const auto found = plan(environment, request);
    return found && std::ranges::any_of(found->messages, [](const messages::Message& message) {
             return message.code == "passes-close-to-land";
           });
  };

  EXPECT_TRUE(warns_of_island(1000.0));
  EXPECT_FALSE(warns_of_island(3000.0));
}

TEST(PlanRoute, VisitsEveryViaInItsOrder) {
  PlanRequest request = eastward_request();
  request.via = {{-53.3, 69.08}, {-52.7, 68.95}};

  const auto found = plan({}, request);

  ASSERT_TRUE(found.has_value());
  std::size_t next = 0;
  for (const Waypoint& waypoint : found->waypoints) {
    if (next < request.via.size() &&
        geo::geodesic_between(waypoint.place, request.via[next]).length.value < 0.01)
      ++next;
  }
  EXPECT_EQ(next, 2U);
}

TEST(PlanRoute, KeepsToTheNumberOfWaypointsAskedFor) {
  PlanRequest request = eastward_request();
  request.refine = false;
  const ocean::Environment environment{.currents = currents_from(tide, 72)};
  const auto full = plan(environment, request);
  ASSERT_TRUE(full.has_value());
  ASSERT_GT(full->waypoints.size(), 4U);

  request.max_waypoints = 4;
  const auto cut = plan(environment, request);

  ASSERT_TRUE(cut.has_value());
  EXPECT_EQ(cut->waypoints.size(), 4U);
}

TEST(PlanRoute, IsRefinedUnlessAskedNotToAndSaysWhatThatSaved) {
  PlanRequest request = eastward_request();
  const ocean::Environment environment{.currents = currents_from(tide, 72)};

  const auto refined = plan(environment, request);
  request.refine = false;
  const auto on_grid = plan(environment, request);

  ASSERT_TRUE(refined && on_grid);
  ASSERT_TRUE(refined->refinement.has_value());
  EXPECT_FALSE(on_grid->refinement.has_value());
  EXPECT_NEAR(refined->refinement->before.count(), on_grid->travel_time().count(), 1e-6);
  EXPECT_NEAR(refined->refinement->after.count(), refined->travel_time().count(), 1e-6);
  EXPECT_LT(refined->travel_time(), on_grid->travel_time());
  EXPECT_FALSE(refined->refinement->trade.empty());
}

TEST(PlanRoute, RefinesToTheNumberOfWaypointsAskedFor) {
  PlanRequest request = eastward_request();
  request.via = {{-53.0, 69.08}};
  request.max_waypoints = 5;

  const auto found = plan({.currents = currents_from(tide, 72)}, request);

  ASSERT_TRUE(found.has_value());
  EXPECT_LE(found->waypoints.size(), 5U);
  EXPECT_TRUE(std::ranges::any_of(found->waypoints, [&](const Waypoint& waypoint) {
    return geo::geodesic_between(waypoint.place, request.via.front()).length.value < 0.01;
  }));
}

TEST(PlanRoute, GoesRoundAnAreaByOnePointWhereNoMoreAreAskedFor) {
  PlanRequest request = eastward_request();
  request.optimality_gap = false;
  ocean::Zone zone;
  zone.area.outer = {{-53.08, 68.97}, {-52.92, 68.97}, {-52.92, 69.04}, {-53.08, 69.04}};
  request.zones = {zone};
  for (const Objective& objective : {time_objective, energy_objective}) {
    request.energy.objective = objective;
    request.max_waypoints.reset();
    const auto best = plan({}, request);
    request.max_waypoints = 3;
    const auto few = plan({}, request);

    ASSERT_TRUE(best && few);
    EXPECT_GT(best->waypoints.size(), 3U) << "its corners";
    EXPECT_EQ(few->waypoints.size(), 3U);
    EXPECT_LT(few->travel_time(), 1.2 * best->travel_time());
  }
}

/// Law: with few waypoints, too, a refined plan is no slower than one that is not.
TEST(PlanRoute, IsNoSlowerForBeingRefinedToFewWaypoints) {
  const ocean::Environment environment{.currents = currents_from(tide, 96)};
  int compared = 0;
  support::for_each_seed(60, [&](std::mt19937_64& rng) {
    PlanRequest request = eastward_request();
    request.optimality_gap = false;
    request.max_waypoints = support::uniform_int(rng, 3, 6);
    request.leg_tolerance = 0.0;
    request.refine_time = core::Seconds{0.2};
    for (int i = 0; i < 5; ++i) {
      const geo::LonLat a{support::uniform(rng, -53.4, -52.7), support::uniform(rng, 68.9, 69.05)};
      const geo::LonLat b{a.lon_deg + support::uniform(rng, 0.02, 0.15),
                          a.lat_deg + support::uniform(rng, 0.02, 0.1)};
      ocean::Zone zone;
      zone.area.outer = {a, {b.lon_deg, a.lat_deg}, b, {a.lon_deg, b.lat_deg}};
      request.zones.push_back(zone);
    }
    const auto refined = planner::try_to_plan(environment, request, {}, {});
    request.refine = false;
    const auto unrefined = planner::try_to_plan(environment, request, {}, {});

    if (!unrefined || unrefined->waypoints.size() > static_cast<std::size_t>(*request.max_waypoints)) return;
    ++compared;
    ASSERT_TRUE(refined.has_value()) << refined.error().explanation();
    EXPECT_LE(refined->waypoints.size(), static_cast<std::size_t>(*request.max_waypoints));
    EXPECT_LE(refined->travel_time().count(), unrefined->travel_time().count() + 1e-3);
    EXPECT_EQ(refined->refinement->after, refined->travel_time());
  });
  EXPECT_GT(compared, 30);
}

TEST(PlanRoute, SaysThatTheStartLiesOnLand) {
  const ocean::Environment environment{
      .bathymetry = bathymetry_from([](geo::LonLat place) { return place.lon_deg < -53.2 ? -20.0 : 300.0; })};

  const auto found = plan(environment, eastward_request());

  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().reason, Reason::start_on_land);
  EXPECT_EQ(found.error().at, eastward_request().from);
}

TEST(PlanRoute, SaysThatTheGoalLiesInsideThePolygonOfAnIsland) {
  ocean::Environment environment;
  environment.land = {
      {.outer = {{-52.6, 68.95}, {-52.4, 68.95}, {-52.4, 69.05}, {-52.6, 69.05}}, .holes = {}}};

  const auto found = plan(environment, eastward_request());

  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().reason, Reason::goal_on_land);
}

TEST(PlanRoute, SaysThatAPlaceToVisitLiesInsideAnIsland) {
  PlanRequest request = eastward_request();
  request.via = {{-53.0, 69.1}};
  ocean::Environment environment;
  environment.land = {
      {.outer = {{-53.1, 69.05}, {-52.9, 69.05}, {-52.9, 69.15}, {-53.1, 69.15}}, .holes = {}}};

  const auto found = plan(environment, request);

  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().reason, Reason::too_shallow);
  EXPECT_EQ(found.error().at, request.via.front());
  EXPECT_NE(found.error().explanation().find("a via point"), std::string::npos);
}

TEST(PlanRoute, SaysThatAWallOfLandLeavesNoWay) {
  const ocean::Environment environment{.bathymetry = bathymetry_from([](geo::LonLat place) {
                                         return std::abs(place.lon_deg + 53.0) < 0.15 ? -1.0 : 300.0;
                                       })};

  PlanRequest request = eastward_request();
  PlanRequest with_timed_area = request;
  with_timed_area.zones = {
      {.name = "later",
       .kind = ocean::ZoneKind::no_go,
       .area = {.outer = {{-53.3, 69.01}, {-53.25, 69.01}, {-53.25, 69.03}}, .holes = {}},
       .from = request.depart,
       .until = request.depart + core::Seconds{3600.0}}};
  for (const PlanRequest& each : {request, with_timed_area}) {
    const auto found = plan(environment, each);

    ASSERT_FALSE(found.has_value());
    EXPECT_EQ(found.error().reason, Reason::goal_unreachable);
    EXPECT_LT(found.error().at.lon_deg, -53.0);
    EXPECT_GT(found.error().at.lon_deg, -53.2) << "as far as the wall";
    EXPECT_FALSE(found.error().suggestion().empty());
  }
}

TEST(PlanRoute, SaysThatTheCurrentIsTooStrong) {
  const auto westward = [](geo::LonLat, double) { return geo::VelocityEn{{-0.5}, {0.0}}; };

  const auto found = plan({.currents = currents_from(westward, 72)}, eastward_request());

  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().reason, Reason::current_too_strong);
}

TEST(PlanRoute, SaysThatTheDataEndBeforeTheRoute) {
  const auto found = plan({.currents = currents_from(tide, 12)}, eastward_request());

  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().reason, Reason::outside_data);
  EXPECT_NE(found.error().explanation().find("end at"), std::string::npos) << found.error().explanation();
}

TEST(PlanRoute, AdvisesAnEarlierDepartureOnlyIfTheDataBeginBefore) {
  ocean::Environment environment{.currents = currents_from(tide, 12)};
  const PlanRequest request = eastward_request();
  const auto advice = testing::HasSubstr("may also depart earlier");

  environment.currents_begin = request.depart;
  const auto at_the_first_hour = plan(environment, request);
  environment.currents_begin = request.depart - core::Seconds{6.0 * 3600.0};
  const auto six_hours_later = plan(environment, request);

  ASSERT_FALSE(at_the_first_hour.has_value() || six_hours_later.has_value());
  EXPECT_THAT(at_the_first_hour.error().explanation(), testing::Not(advice));
  EXPECT_THAT(six_hours_later.error().explanation(), advice);
}

TEST(PlanRoute, AdvisesALargerAgeOfSightingsOnlyIfThatHelps) {
  const PlanRequest request = eastward_request();
  ocean::Iceberg old;
  old.id = "B-17";
  old.place = {-50.5, 70.4};
  old.too_old_from = request.depart;
  const auto advised = [&](double age_days) {
    old.observed = request.depart - core::Seconds{age_days * 86'400.0};
    const auto made = plan({.icebergs = {old}}, request);
    const auto told = messages::sentences(made.value().messages);
    EXPECT_THAT(told, testing::Contains(testing::HasSubstr("1 iceberg was ignored (B-17)")));
    return std::ranges::any_of(
        told, [](const std::string& text) { return text.find("--max-sighting-age") != std::string::npos; });
  };

  EXPECT_TRUE(advised(5.0));
  EXPECT_FALSE(advised(40.0));
}

/// The data of these tests end at 50 W; a degree of longitude has 40 km there.
PlanRequest request_beyond_the_data() {
  PlanRequest request = eastward_request();
  request.from = {-50.5, 69.0};
  request.to = {-49.7, 69.0};
  request.refine = false;
  return request;
}

TEST(PlanRoute, NamesTheDepthsThatAGoalLiesOutside) {
  const auto depths = bathymetry_from([](geo::LonLat) { return 500.0; });

  const auto found = plan({.bathymetry = depths}, request_beyond_the_data());

  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(
      found.error().explanation(),
      "the goal lies 12.0 km east of the stored bathymetry (area of the data near here: 56° W to 50° W, "
      "67.5° N to 70.5° N)");
  EXPECT_NE(found.error().suggestion().find("--bathymetry none"), std::string::npos);
}

TEST(PlanRoute, DoesNotAdviseToLeaveOutDepthsWhereTheCurrentsEndToo) {
  const auto depths = bathymetry_from([](geo::LonLat) { return 500.0; });

  const auto found =
      plan({.currents = currents_from(tide, 24), .bathymetry = depths}, request_beyond_the_data());

  ASSERT_FALSE(found.has_value());
  EXPECT_NE(found.error().explanation().find("and 12.0 km east of the stored currents"), std::string::npos)
      << found.error().explanation();
  EXPECT_EQ(found.error().suggestion(), "Move the goal, or ingest bathymetry and currents that cover it");
}

TEST(PlanRoute, NamesTheCurrentsThatAGoalLiesOutside) {
  const auto found = plan({.currents = currents_from(tide, 72)}, request_beyond_the_data());

  ASSERT_FALSE(found.has_value());
  EXPECT_THAT(found.error().explanation(),
              testing::StartsWith("the goal lies 12.0 km east of the stored currents"));
  EXPECT_EQ(found.error().suggestion(),
            "Move the goal into the water of the currents, or ingest currents that cover it");
}

/// Water of the model only in the west of the grid, as on a bent grid, which fills its box in part.
geo::VelocityEn still_water_in_the_west(geo::LonLat place, double) {
  return place.lon_deg < -52.95 ? geo::VelocityEn{{0.0}, {0.0}} : geo::VelocityEn{{NAN}, {NAN}};
}

TEST(PlanRoute, NamesAGoalOutsideTheCurrentsAlsoWhereTheSearchEndedAtTheirLastHour) {
  for (const int hours : {4, 72}) {
    const auto found = plan({.currents = currents_from(still_water_in_the_west, hours)}, eastward_request());

    ASSERT_FALSE(found.has_value());
    EXPECT_THAT(found.error().explanation(), testing::StartsWith("the goal lies ")) << hours;
    EXPECT_EQ(found.error().reason, Reason::outside_data);
  }
}

TEST(PlanRoute, NamesAStartOutsideTheCurrentsBeforeAGoalOutsideThem) {
  PlanRequest request = request_beyond_the_data();
  request.from = {-49.8, 69.0};

  const auto found = plan({.currents = currents_from(tide, 72)}, request);

  ASSERT_FALSE(found.has_value());
  EXPECT_THAT(found.error().explanation(), testing::MatchesRegex("the start lies .* east of .*"
                                                                 "\\. The goal lies 12.0 km east of .*"));
  EXPECT_EQ(found.error().at, request.from);
  EXPECT_EQ(found.error().suggestion(),
            "Move the start into the water of the currents, or ingest currents that cover it");
}

TEST(PlanRoute, TellsTheNearestWaterOfTheCurrentsToAGoalWithinTheirBox) {
  const auto found = plan({.currents = currents_from(still_water_in_the_west, 72)}, eastward_request());

  ASSERT_FALSE(found.has_value());
  EXPECT_THAT(
      found.error().explanation(),
      testing::HasSubstr("east of the nearest water of the stored currents, which is at -53.0000, 69.0000"));
  EXPECT_THAT(found.error().explanation(), testing::Not(testing::HasSubstr("area of the data")));
  EXPECT_EQ(found.error().suggestion(),
            "Move the goal into the water of the currents, or ingest currents that cover it");
}

TEST(PlanRoute, SaysThatTheCurrentsHaveNoWaterInTheSearchArea) {
  const auto dry = [](geo::LonLat, double) { return geo::VelocityEn{{NAN}, {NAN}}; };

  const auto found = plan({.currents = currents_from(dry, 72)}, eastward_request());

  ASSERT_FALSE(found.has_value());
  EXPECT_THAT(found.error().explanation(),
              testing::HasSubstr("The goal lies where the stored currents have no water"));
}

TEST(PlanRoute, SaysThatTheWaterOfTheModelEndsOnTheWay) {
  const auto gap = [](geo::LonLat place, double) {
    return place.lon_deg > -53.3 && place.lon_deg < -52.7 ? geo::VelocityEn{{NAN}, {NAN}}
                                                          : geo::VelocityEn{{0.0}, {0.0}};
  };

  const auto found = plan({.currents = currents_from(gap, 72)}, eastward_request());

  ASSERT_FALSE(found.has_value());
  EXPECT_THAT(found.error().explanation(), testing::HasSubstr("the water of the model ends there"));
}

TEST(PlanRoute, SaysThatTheDepthsEndOnTheWay) {
  const auto gap = [](geo::LonLat p) { return p.lon_deg > -53.1 && p.lon_deg < -52.9 ? NAN : 500.0; };

  const auto found = plan({.bathymetry = bathymetry_from(gap)}, eastward_request());

  ASSERT_FALSE(found.has_value());
  EXPECT_NE(found.error().explanation().find("Beyond this place the stored depths have no values"),
            std::string::npos)
      << found.error().explanation();
}

TEST(PlanRoute, StopsWhenAsked) {
  std::stop_source source;
  source.request_stop();

  const auto found = plan_route({}, eastward_request(), source.get_token(), {});

  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().reason, Reason::cancelled);
}

TEST(PlanRoute, RefusesARequestThatBreaksItsRules) {
  PlanRequest request = eastward_request();
  request.to = request.from;
  EXPECT_THROW((void)plan({}, request), std::invalid_argument);
}

TEST(PlanRoute, RefusesAGridThatWouldNotFitIntoMemory) {
  PlanRequest request = eastward_request();
  request.spacing_along = core::Metres{2.0};

  const auto found = plan({}, request);

  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().reason, Reason::too_large);
}

}  // namespace
}  // namespace floeplan::planning::plan_route_test

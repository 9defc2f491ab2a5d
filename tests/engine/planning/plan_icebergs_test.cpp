#include <gtest/gtest.h>

#include <cmath>

#include "engine/geo/geodesic.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/planning/evaluate_route.hpp"
#include "engine/planning/plan_route.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning {
namespace {

using support::uniform;

const core::UtcTime start = core::from_unix_seconds(support::sea_start_s);
constexpr double hour_s = 3600.0;

/// Seen twice, half a day apart, so that its drift is known where no current is.
ocean::Iceberg drifting_berg(geo::LonLat place, double length_m, double speed_m_s, double towards_deg) {
  ocean::Iceberg berg = support::iceberg_at(place, length_m);
  const core::Seconds before{12.0 * hour_s};
  berg.earlier = {{geo::geodesic_destination(place, geo::Bearing::degrees(towards_deg + 180.0),
                                             core::Metres{speed_m_s * before.count()}),
                   start - before}};
  return berg;
}

Result<Plan> plan(const ocean::Environment& environment, const PlanRequest& request) {
  return plan_route(environment, request, {}, {});
}

/// Least distance of the plan's vehicle from the rim of any disc, by a simulation of its own in steps of a second:
/// the vehicle moves evenly between its waypoints, each berg evenly along its observed drift. Bergs are seen at the
/// start.
double least_gap_m(const Plan& plan, const ocean::Environment& environment, const IcebergRules& rules) {
  const geo::LocalProjection projection{plan.waypoints.front().place};
  struct Disc {
    geo::PlanePoint centre;
    geo::PlaneVelocity drift;
    double hull_m;
    double error_m;
  };
  std::vector<Disc> discs;
  for (const ocean::Iceberg& berg : environment.icebergs) {
    const geo::PlanePoint now = projection.to_plane(berg.place);
    geo::PlaneVelocity drift{};
    if (!berg.earlier.empty()) {
      const geo::PlanePoint then = projection.to_plane(berg.earlier[0].place);
      const double span_s = (berg.observed - berg.earlier[0].time).count();
      drift = {(now.x_m - then.x_m) / span_s, (now.y_m - then.y_m) / span_s};
    }
    discs.push_back(
        {now, drift, 0.5 * berg.length->value, berg.position_uncertainty.value_or(core::Metres{0.0}).value});
  }
  double least_m = INFINITY;
  for (std::size_t i = 1; i < plan.waypoints.size(); ++i) {
    const geo::PlanePoint a = projection.to_plane(plan.waypoints[i - 1].place);
    const geo::PlanePoint b = projection.to_plane(plan.waypoints[i].place);
    const double t0_s = (plan.waypoints[i - 1].eta - start).count();
    const double t1_s = (plan.waypoints[i].eta - start).count();
    for (double t_s = t0_s; t_s <= t1_s; t_s += 1.0) {
      const double share = (t_s - t0_s) / (t1_s - t0_s);
      const double x_m = a.x_m + share * (b.x_m - a.x_m);
      const double y_m = a.y_m + share * (b.y_m - a.y_m);
      for (const Disc& disc : discs) {
        const double radius_m = disc.hull_m + rules.margin.value +
                                std::min(disc.error_m + t_s * 0.75 / 3.6, rules.max_inflation.value);
        least_m = std::min(least_m, std::hypot(x_m - disc.centre.x_m - t_s * disc.drift.x_m_s,
                                               y_m - disc.centre.y_m - t_s * disc.drift.y_m_s) -
                                        radius_m);
      }
    }
  }
  return least_m;
}

/// A course held is straight in the plane only near the equator, where the random scenes are.
constexpr double tolerance_m = 3.0;

/// Shallow water all along 53 W, but for a gap of about 10 km at 69 N.
std::shared_ptr<const ocean::Bathymetry> wall_with_a_gap() {
  return support::bathymetry_from([](geo::LonLat p) {
    const bool in_wall = std::abs(p.lon_deg + 53.0) < 0.15;
    const bool in_gap = std::abs(p.lat_deg - 69.0) < 0.026;
    return in_wall && !in_gap ? 5.0 : 300.0;
  });
}

TEST(PlanAmongIcebergs, FindsTheOnlyWayThroughWhenItOpensLater) {
  // A berg drifts eastwards through the gap at a third of the vehicle's speed and closes all of it meanwhile.
  PlanRequest request = support::eastward_request();
  request.icebergs.margin = core::Metres{5500.0};
  request.icebergs.max_inflation = core::Metres{0.0};
  ocean::Environment environment{.bathymetry = wall_with_a_gap()};
  const Result<Plan> free = plan(environment, request);
  environment.icebergs = {drifting_berg({-53.2, 69.0}, 100.0, 0.12, 90.0)};

  const Result<Plan> later = plan(environment, request);

  ASSERT_TRUE(free.has_value());
  ASSERT_TRUE(later.has_value()) << later.error().explanation;
  EXPECT_GT(later->travel_time().count(), free->travel_time().count() + 3.0 * hour_s);
  EXPECT_GT(later->clearances.iceberg->value, request.icebergs.margin.value);
}

TEST(PlanAmongIcebergs, NeverLeadsIntoADiscWhenSimulatedSecondBySecond) {
  int found = 0;
  int detours = 0;
  support::for_each_seed(500, [&](std::mt19937_64& rng) {
    PlanRequest request = support::eastward_request();
    request.from = {-40.06, 0.1};
    request.to = {-39.94, 0.1};
    request.icebergs.margin = core::Metres{uniform(rng, 200.0, 1000.0)};
    request.icebergs.max_inflation = core::Metres{uniform(rng, 0.0, 1500.0)};
    ocean::Environment environment;
    const int bergs = support::uniform_int(rng, 1, 6);
    for (int i = 0; i < bergs; ++i) {
      const geo::LonLat place{uniform(rng, -40.1, -39.9), uniform(rng, 0.04, 0.16)};
      environment.icebergs.push_back(
          drifting_berg(place, uniform(rng, 10.0, 300.0), uniform(rng, 0.0, 0.3), uniform(rng, 0.0, 360.0)));
      if (i % 2 == 0)
        environment.icebergs.back().position_uncertainty = core::Metres{uniform(rng, 0.0, 500.0)};
    }

    const Result<Plan> result = plan(environment, request);

    if (!result) return;
    ++found;
    detours += result->waypoints.size() > 2 ? 1 : 0;
    EXPECT_GT(least_gap_m(*result, environment, request.icebergs), -tolerance_m);
  });
  EXPECT_GT(found, 250);
  EXPECT_GT(detours, 100);
}

TEST(PlanAmongIcebergs, IsTheOneWithoutThemWhereTheyAreFar) {
  const ocean::Environment empty;
  ocean::Environment far;
  far.icebergs = {drifting_berg({-51.0, 70.0}, 100.0, 0.2, 90.0)};
  const PlanRequest request = support::eastward_request();

  const Result<Plan> with = plan(far, request);
  const Result<Plan> without = plan(empty, request);

  ASSERT_TRUE(with && without);
  EXPECT_EQ(with->arrival, without->arrival);
  EXPECT_EQ(with->search.expansions, without->search.expansions);
  ASSERT_TRUE(with->clearances.iceberg);
  EXPECT_GT(with->clearances.iceberg->value, 50'000.0);
}

TEST(PlanAmongIcebergs, ReportsTheLeastDistanceFromTheHullOverTime) {
  // A standing berg beside the straight way: the clearance is the distance of the line.
  const PlanRequest request = support::eastward_request();
  const geo::LonLat middle = geo::geodesic_destination(
      request.from, geo::geodesic_between(request.from, request.to).course_at_start, core::Metres{20'000.0});
  ocean::Environment environment;
  environment.icebergs = {support::iceberg_at(
      geo::geodesic_destination(middle, geo::Bearing::degrees(180.0), core::Metres{15'000.0}), 200.0)};

  const Result<Plan> result = plan(environment, request);

  ASSERT_TRUE(result);
  EXPECT_NEAR(result->clearances.iceberg->value, 14'900.0, 20.0);
  ASSERT_TRUE(result->iceberg_encounters);
  EXPECT_GT(*result->iceberg_encounters, 0.0);
  EXPECT_LT(*result->iceberg_encounters, 0.05);
  double of_legs = 0.0;
  for (const Waypoint& waypoint : result->waypoints) of_legs += waypoint.iceberg_encounters.value_or(0.0);
  EXPECT_NEAR(of_legs, *result->iceberg_encounters, 1e-12);
}

TEST(PlanAmongIcebergs, CannotBeginInsideADiscAndNamesTheBerg) {
  PlanRequest request = support::eastward_request();
  ocean::Environment environment;
  environment.icebergs = {support::iceberg_at({-53.47, 69.0}, 100.0)};
  environment.icebergs[0].id = "B-17";
  environment.icebergs[0].observed = start - core::Seconds{4.0 * hour_s};

  const Result<Plan> result = plan(environment, request);

  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().reason, Reason::start_near_iceberg);
  EXPECT_NE(result.error().explanation.find("B-17"), std::string::npos) << result.error().explanation;
  EXPECT_NE(result.error().explanation.find("3000 m for the error"), std::string::npos)
      << result.error().explanation;
}

TEST(PlanAmongIcebergs, MayEndWhereABergIsGoneByThen) {
  // At the departure the goal lies inside the disc; when the vehicle comes, the berg is far to the north.
  PlanRequest request = support::eastward_request();
  request.icebergs.max_inflation = core::Metres{0.0};
  ocean::Environment environment;
  environment.icebergs = {drifting_berg(request.to, 100.0, 0.3, 0.0)};

  EXPECT_TRUE(plan(environment, request).has_value());

  request.icebergs.drift = false;
  const Result<Plan> standing = plan(environment, request);
  ASSERT_FALSE(standing);
  EXPECT_EQ(standing.error().reason, Reason::goal_near_iceberg);
}

TEST(PlanAmongIcebergs, NamesTheBergInTheWayOfAGivenRoute) {
  const PlanRequest request = support::eastward_request();
  ocean::Environment environment;
  environment.icebergs = {support::iceberg_at({-53.0, 69.0}, 100.0)};
  environment.icebergs[0].id = "57";

  const Result<Plan> result = evaluate_route(environment, {request.from, request.to}, request);

  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().reason, Reason::near_iceberg);
  EXPECT_NE(result.error().explanation.find("iceberg 57 at "), std::string::npos)
      << result.error().explanation;
  EXPECT_GT(result.error().when, request.depart);
}

TEST(PlanAmongIcebergs, RefusesMoreIcebergsThanCanBeForecast) {
  ocean::Environment environment;
  environment.icebergs.assign(1'000'000, support::iceberg_at({-53.0, 69.2}, 100.0));

  const Result<Plan> result = plan(environment, support::eastward_request());

  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().reason, Reason::too_large);
}

TEST(PlanAmongIcebergs, EndsSoonAfterItIsCancelled) {
  // Bergs that drift to and fro everywhere keep the search among later arrivals busy.
  std::mt19937_64 rng{7};
  PlanRequest request = support::eastward_request();
  request.spacing_along = core::Metres{250.0};
  request.icebergs.max_inflation = core::Metres{0.0};
  ocean::Environment environment;
  for (int i = 0; i < 300; ++i) {
    environment.icebergs.push_back(drifting_berg({uniform(rng, -53.4, -52.6), uniform(rng, 68.8, 69.2)},
                                                 100.0, uniform(rng, 0.05, 0.3), uniform(rng, 0.0, 360.0)));
  }
  std::stop_source stop;
  const auto progress = [&](std::string_view stage, double) {
    if (stage == "search") stop.request_stop();
  };

  const Result<Plan> result = plan_route(environment, request, stop.get_token(), progress);

  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().reason, Reason::cancelled);
}

}  // namespace
}  // namespace floeplan::planning

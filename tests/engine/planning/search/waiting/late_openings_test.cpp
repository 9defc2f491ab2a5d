#include "engine/planning/search/waiting/late_openings.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/messages/sentence.hpp"
#include "engine/planning/plan_route.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::search::late_openings_test {
namespace {

constexpr double wall_end_deg = 69.25;
constexpr double no_end_deg = 90.0;

/// A wall of land across the way with a strait in it, which the vehicle reaches after about 11 hours. Until the
/// hour `opens` the water in the strait runs against it at 0.6 m/s, an hour later it stands. The wall ends in
/// the north at `end_deg`.
ocean::Environment strait(double opens_h, double end_deg) {
  const auto currents = [=](geo::LonLat place, double hour) {
    const bool in_strait = std::abs(place.lon_deg + 53.0) < 0.25 && std::abs(place.lat_deg - 69.0) < 0.12;
    return geo::VelocityEn{{in_strait && hour <= opens_h ? -0.6 : 0.0}, {0.0}};
  };
  const auto depth_m = [=](geo::LonLat place) {
    const bool wall = std::abs(place.lon_deg + 53.0) < 0.15 && std::abs(place.lat_deg - 69.0) > 0.04 &&
                      place.lat_deg < end_deg;
    return wall ? -1.0 : 300.0;
  };
  return {.currents = support::currents_from(currents, 240), .bathymetry = support::bathymetry_from(depth_m)};
}

PlanRequest coarse_request() {
  PlanRequest request = support::eastward_request();
  request.spacing_along = core::Metres{2000.0};
  return request;
}

core::UtcTime at_hour(double hour) { return core::from_unix_seconds(support::sea_start_s + 3600.0 * hour); }

TEST(LateOpenings, AreReportedWhereAStraitOpensAfterTheSearchWasThere) {
  const PlanRequest request = coarse_request();
  const ocean::Environment environment = strait(20.0, wall_end_deg);

  const auto found = plan_route(environment, request, {}, {});

  ASSERT_TRUE(found.has_value()) << found.error().explanation();
  EXPECT_GT(found->search.fifo_violations, 0);
  ASSERT_TRUE(found->search.worst_fifo_violation.has_value());
  const LateOpening& worst = *found->search.worst_fifo_violation;
  EXPECT_NEAR(worst.place.lon_deg, -53.0, 0.5);  // legs are up to 10 km long
  EXPECT_NEAR(worst.place.lat_deg, 69.0, 0.15);
  EXPECT_LT(worst.refused, worst.opens);
  EXPECT_LT(worst.opens, at_hour(21.0));
  EXPECT_GT(worst.gain.value().count(), 60.0);
  EXPECT_NE(messages::sentences(found->messages).back().find("too strong"), std::string::npos)
      << messages::sentences(found->messages).back();
}

TEST(LateOpenings, AreThereForThoseWhoDepartLater) {
  PlanRequest request = coarse_request();
  request.refine = false;  // which shortens the early one's way round by more than the strait saves
  const ocean::Environment environment = strait(20.0, wall_end_deg);
  const auto early = plan_route(environment, request, {}, {});

  request.depart = at_hour(10.0);
  const auto late = plan_route(environment, request, {}, {});

  ASSERT_TRUE(early && late);
  EXPECT_LT(late->arrival, early->arrival) << "leaving later arrives earlier: this sea is not FIFO";
}

TEST(LateOpenings, AreWhatHelpsWhenThereIsNoOtherWay) {
  const auto found = plan_route(strait(60.0, no_end_deg), coarse_request(), {}, {});

  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().reason, Reason::current_too_strong);
  EXPECT_NE(found.error().explanation().find("the vehicle could be there at"), std::string::npos)
      << found.error().explanation();
  EXPECT_NE(found.error().suggestion().find("depart later"), std::string::npos);
}

/// Who waits at a place in the way of the strait need not leave later, and is no later than who did.
TEST(LateOpenings, AreWaitedForWhereTheRequestAllowsIt) {
  PlanRequest request = coarse_request();
  request.refine = false;
  const ocean::Environment environment = strait(20.0, wall_end_deg);
  core::UtcTime best_of_later = at_hour(240.0);
  for (double hour = 8.0; hour <= 14.0; hour += 0.5) {
    request.depart = at_hour(hour);
    if (const auto later = plan_route(environment, request, {}, {}))
      best_of_later = std::min(best_of_later, later->arrival);
  }
  request.depart = at_hour(0.0);
  request.max_loiter = core::Seconds{3600.0 * 24.0};

  const auto found = plan_route(environment, request, {}, {});

  ASSERT_TRUE(found.has_value()) << found.error().explanation();
  EXPECT_LE(found->arrival, best_of_later + core::Seconds{60.0});
  EXPECT_FALSE(found->search.worst_fifo_violation.has_value());
  const auto waits =
      std::ranges::count_if(found->waypoints, [](const Waypoint& w) { return w.wait.count() > 0.0; });
  EXPECT_GE(waits, 1);
  for (const Waypoint& waypoint : found->waypoints) EXPECT_LE(waypoint.wait, request.max_loiter);
}

TEST(LateOpenings, AreWaitedForByRefinedPlansNoLess) {
  PlanRequest request = coarse_request();
  request.max_loiter = core::Seconds{3600.0 * 24.0};
  const ocean::Environment environment = strait(20.0, no_end_deg);

  const auto refined = plan_route(environment, request, {}, {});
  request.refine = false;
  const auto on_grid = plan_route(environment, request, {}, {});

  ASSERT_TRUE(on_grid.has_value()) << on_grid.error().explanation();
  ASSERT_TRUE(refined.has_value()) << refined.error().explanation();
  EXPECT_LE(refined->arrival, on_grid->arrival);
  EXPECT_GT(refined->arrival, at_hour(20.0));
}

/// A stream of 32 km that stands until the hour 12, when a vehicle that went at once is in the middle of it, and again
/// from the hour 30 on: nobody can keep a place in it meanwhile.
TEST(LateOpenings, AreWaitedForWhereAStreamLetsInButNotOut) {
  const auto currents = [](geo::LonLat place, double hour) {
    const bool in_stream = std::abs(place.lon_deg + 53.0) < 0.4;
    return geo::VelocityEn{{in_stream && hour > 12.0 && hour < 30.0 ? -0.6 : 0.0}, {0.0}};
  };
  const ocean::Environment environment{.currents = support::currents_from(currents, 240)};
  PlanRequest request = coarse_request();
  request.to.lon_deg += 0.3;
  request.refine = false;
  core::UtcTime best_of_later = at_hour(240.0);
  for (double hour = 16.0; hour <= 30.0; hour += 1.0) {
    request.depart = at_hour(hour);
    if (const auto later = plan_route(environment, request, {}, {}))
      best_of_later = std::min(best_of_later, later->arrival);
  }
  request.depart = at_hour(0.0);
  request.max_loiter = core::Seconds{3600.0 * 36.0};

  const auto found = plan_route(environment, request, {}, {});

  ASSERT_LT(best_of_later, at_hour(200.0));
  ASSERT_TRUE(found.has_value()) << found.error().explanation();
  EXPECT_LE(found->arrival, best_of_later + core::Seconds{60.0});
  for (const Waypoint& waypoint : found->waypoints) EXPECT_LE(waypoint.wait, request.max_loiter);
}

TEST(LateOpenings, AreNamedWithTheWaitThatHelps) {
  PlanRequest request = coarse_request();
  request.to.lon_deg = -52.75;
  const ocean::Environment environment = strait(40.0, no_end_deg);

  const auto refused = plan_route(environment, request, {}, {});

  ASSERT_FALSE(refused.has_value());
  const auto& changes = refused.error().changes;
  const auto wait = std::ranges::find(changes, "max_loiter_s", &Change::input);
  ASSERT_NE(wait, changes.end());
  request.max_loiter = core::Seconds{std::get<double>(wait->to)};
  EXPECT_TRUE(plan_route(environment, request, {}, {}).has_value());
}

TEST(LateOpenings, AreTheSameForEveryExactSearch) {
  PlanRequest request = coarse_request();
  const ocean::Environment environment = strait(20.0, wall_end_deg);
  for (const Method method : {Method::tve, Method::dijkstra, Method::astar}) {
    request.method = method;

    const auto found = plan_route(environment, request, {}, {});

    ASSERT_TRUE(found.has_value());
    EXPECT_GT(found->search.fifo_violations, 0) << method_name(method);
    EXPECT_EQ(found->search.reinsertions, 0) << "positive times: no vertex is expanded twice";
  }
}

TEST(LateOpenings, AreNoneWhereTheCurrentNeverBeatsTheVehicle) {
  support::for_each_seed(5, [](std::mt19937_64& rng) {
    const double phase = support::uniform(rng, 0.0, 6.28);
    const auto tide = [&](geo::LonLat place, double hour) {
      return geo::VelocityEn{{0.2 * std::cos(0.5 * hour + phase)},
                             {0.2 * std::sin(0.5 * hour + 3.0 * place.lon_deg)}};
    };

    const auto found = plan_route({.currents = support::currents_from(tide, 96)}, coarse_request(), {}, {});

    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->search.fifo_violations, 0);
    EXPECT_FALSE(found->search.worst_fifo_violation.has_value());
  });
}

}  // namespace
}  // namespace floeplan::planning::search::late_openings_test

#include "engine/planning/search/route_ground.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "engine/planning/evaluate_route.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::search::route_ground_test {
namespace {

using support::uniform;
using support::uniform_int;

/// Currents that turn in space and time, a bank in the bathymetry and some drifting icebergs.
ocean::Environment random_sea(std::mt19937_64& rng) {
  const double strength = uniform(rng, 0.0, 0.25);
  const double phase = uniform(rng, 0.0, 6.0);
  ocean::Environment environment;
  environment.currents = support::currents_from(
      [&](geo::LonLat place, double hour) {
        const double turn = phase + 0.5 * hour + 3.0 * place.lon_deg + 5.0 * place.lat_deg;
        return geo::VelocityEn{core::MetresPerSecond{strength * std::cos(turn)},
                               core::MetresPerSecond{strength * std::sin(turn)}};
      },
      72);
  environment.bathymetry = support::bathymetry_from([&](geo::LonLat place) {
    return 350.0 + 250.0 * std::sin(phase + 2.0 * place.lon_deg) * std::cos(4.0 * place.lat_deg);
  });
  for (int i = uniform_int(rng, 0, 2); i > 0; --i) {
    environment.icebergs.push_back(support::iceberg_at({uniform(rng, -53.4, -52.6), uniform(rng, 68.7, 69.3)},
                                                       uniform(rng, 20.0, 300.0)));
  }
  return environment;
}

std::vector<geo::LonLat> random_route(std::mt19937_64& rng) {
  std::vector<geo::LonLat> route{{-53.5, 69.0}};
  for (int i = uniform_int(rng, 0, 4), n = i + 1; i > 0; --i)
    route.push_back({-52.5 - static_cast<double>(i) / n, uniform(rng, 68.9, 69.1)});
  route.push_back({-52.5, 69.0});
  return route;
}

std::vector<geo::LonLat> nudged(std::mt19937_64& rng, std::vector<geo::LonLat> route) {
  geo::LonLat& moved =
      route[static_cast<std::size_t>(uniform_int(rng, 0, static_cast<int>(route.size()) - 1))];
  moved.lon_deg += uniform(rng, -0.01, 0.01);
  moved.lat_deg += uniform(rng, -0.004, 0.004);
  return route;
}

void expect_same(const Result<Plan>& a, const Result<Plan>& b) {
  ASSERT_EQ(a.has_value(), b.has_value());
  if (!a) {
    EXPECT_EQ(a.error().reason, b.error().reason);
    EXPECT_EQ(a.error().explanation(), b.error().explanation());
    return;
  }
  EXPECT_EQ(a->travel_time(), b->travel_time());
  EXPECT_EQ(a->optimality_gap, b->optimality_gap);
  EXPECT_EQ(a->messages, b->messages);
  ASSERT_EQ(a->waypoints.size(), b->waypoints.size());
  for (std::size_t i = 0; i < a->waypoints.size(); ++i) EXPECT_EQ(a->waypoints[i].eta, b->waypoints[i].eta);
}

TEST(RouteGround, GivesTheSameFiguresWhicheverRouteItWasLaidOutFor) {
  int shared = 0;
  int open = 0;
  constexpr int tries = 12;
  support::for_each_seed(tries, [&](std::mt19937_64& rng) {
    const ocean::Environment environment = random_sea(rng);
    PlanRequest request = support::eastward_request();
    if (uniform_int(rng, 0, 1) == 1) request.spacing_along.reset();
    const std::vector<geo::LonLat> first = random_route(rng);
    const std::vector<geo::LonLat> second = nudged(rng, first);

    const PlanRequest along_first = request_along(first, request);
    const RouteSite site = site_of(along_first);
    if (site_of(request_along(second, request)) != site) return;
    ++shared;
    const auto ground = lay_out_ground(environment, along_first, site, {});
    ASSERT_TRUE(ground.has_value());
    const auto anew = evaluate_route(environment, second, request);
    expect_same(evaluate_route(**ground, second, request), anew);
    if (anew) ++open;
    // The evaluation of a route does not change it.
    expect_same(evaluate_route(**ground, first, request), evaluate_route(environment, first, request));
  });
  EXPECT_GT(shared, tries / 2) << "a waypoint that is moved by some hundred metres seldom changes the site";
  EXPECT_GT(open, tries / 4);
}

TEST(RouteGround, HoldsTheRouteAndIsAsFineAsAskedFor) {
  support::for_each_seed(200, [](std::mt19937_64& rng) {
    PlanRequest request = support::eastward_request();
    request.spacing_along = core::Metres{uniform(rng, 100.0, 4000.0)};
    std::vector<geo::LonLat> route;
    const double lat_deg = uniform(rng, -89.0, 89.0);
    for (int i = 0; i < 4; ++i)
      route.push_back(
          {geo::wrap_longitude(179.5 + uniform(rng, -1.0, 1.0)), lat_deg + uniform(rng, -0.9, 0.9)});

    const RouteSite site = site_of(request_along(route, request));
    const geo::LocalProjection projection{site.origin};
    for (const geo::LonLat place : route)
      EXPECT_TRUE(site.area.grown(-2.0 * site.cell.value).contains(projection.to_plane(place)));
    EXPECT_LE(site.cell, *request.spacing_along);
  });
}

TEST(RouteGround, OfARouteThatPassesUnderIcebergsIsThatOfItsEnds) {
  PlanRequest request = support::eastward_request();
  const std::vector<geo::LonLat> route{{-53.5, 69.0}, {-53.0, 69.02}, {-52.5, 69.0}};
  std::vector<geo::LonLat> moved = route;
  moved[1].lat_deg += 1e-6;
  EXPECT_EQ(site_of(request_along(route, request)), site_of(request_along(moved, request)));

  request.icebergs.pass_under = true;
  EXPECT_EQ(site_of(request_along(route, request)), site_of(request_along(moved, request)));
  moved.back().lat_deg += 1e-6;
  EXPECT_NE(site_of(request_along(route, request)), site_of(request_along(moved, request)));
}

TEST(RouteGround, OfAnotherSiteIsRefused) {
  const PlanRequest request = support::eastward_request();
  const PlanRequest along = request_along({{-53.5, 69.0}, {-52.5, 69.0}}, request);
  const auto ground = lay_out_ground({}, along, site_of(along), {});
  ASSERT_TRUE(ground.has_value());

  EXPECT_THROW((void)evaluate_route(**ground, {{-50.0, 70.0}, {-49.0, 70.0}}, request),
               std::invalid_argument);
}

/// Law: the stated size covers all memory that is kept; otherwise the cache would exceed its limit.
TEST(RouteGround, TellsOfTheMemoryThatEachPartOfTheSeaTakes) {
  const std::vector<geo::LonLat> route{{-53.5, 69.0}, {-52.5, 69.0}};
  const PlanRequest on_route = request_along(route, support::eastward_request());
  const RouteSite site = site_of(on_route);
  const auto bytes_in = [&](const ocean::Environment& environment) {
    return RouteGround{environment, on_route, site, {}}.bytes();
  };
  ocean::Environment environment;
  std::size_t before = bytes_in(environment);
  const auto grows_by_at_least = [&](std::size_t least) {
    const std::size_t now = bytes_in(environment);
    EXPECT_GE(now, before + least);
    before = now;
  };

  const std::size_t nodes = support::sea_grid().size();
  environment.bathymetry = support::bathymetry_from([](geo::LonLat) { return 500.0; });
  grows_by_at_least(nodes * sizeof(float));
  environment.ice = support::ice_from([](geo::LonLat, double) { return 0.5; }, {0.0, 24.0});
  grows_by_at_least(2 * nodes * sizeof(float));
  environment.land.push_back({.outer = geo::Ring(10'000, geo::LonLat{-54.0, 70.0}), .holes = {}});
  grows_by_at_least(10'000 * sizeof(geo::LonLat));
  environment.currents =
      support::currents_from([](geo::LonLat, double) { return geo::VelocityEn{{0.05}, {0.02}}; }, 48);
  grows_by_at_least(49 * 2 * sizeof(float));
  environment.icebergs.assign(20, support::iceberg_at({-53.0, 69.1}, 100.0));
  constexpr std::size_t hourly_places = 49;
  grows_by_at_least(20 * hourly_places * 2 * sizeof(double));
}

}  // namespace
}  // namespace floeplan::planning::search::route_ground_test

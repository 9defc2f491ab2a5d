#include "engine/planning/cost/straightening.hpp"

#include <gtest/gtest.h>

#include "engine/planning/cost/route_cost.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::cost::straightening_test {
namespace {

const geo::LocalProjection projection{{-53.0, 69.0}};
const plane::PlaneBox area{{-40'000.0, -40'000.0}, {40'000.0, 40'000.0}};

struct Scene {
  ocean::Environment environment;
  PlanRequest request{support::eastward_request()};
  Sea sea{environment, request, projection, area, core::Metres{500.0}};
};

Scene tidal_scene() {
  return {.environment = {.currents = support::currents_from(
                              [](geo::LonLat p, double hour) {
                                return geo::VelocityEn{{0.1 * std::cos(hour / 2.0)},
                                                       {0.15 * std::sin(hour / 2.0 + 4.0 * p.lon_deg)}};
                              },
                              240)}};
}

Route random_route(std::mt19937_64& rng) {
  std::uniform_real_distribution<double> sway{-6000.0, 6000.0};
  Route route;
  for (int i = 0; i <= 10; ++i) {
    route.points.push_back({-20'000.0 + 4000.0 * i, i % 10 == 0 ? 0.0 : sway(rng)});
    route.fixed.push_back(i % 5 == 0);
  }
  return route;
}

core::Seconds arrival(const Sea& sea, const Route& route) {
  return arrivals_along(sea, route.points, core::Seconds{0.0}).value().back();
}

TEST(Straightening, NeverArrivesLaterAndKeepsFixedPoints) {
  const Scene scene = tidal_scene();
  support::for_each_seed(20, [&](std::mt19937_64& rng) {
    const Route route = random_route(rng);

    const Route result = drop_needless_points(scene.sea, route, core::Seconds{0.0});

    EXPECT_LE(arrival(scene.sea, result), arrival(scene.sea, route));
    EXPECT_EQ(std::ranges::count(result.fixed, true), std::ranges::count(route.fixed, true));
    EXPECT_EQ(result.points.front(), route.points.front());
    EXPECT_EQ(result.points.back(), route.points.back());
  });
}

TEST(Straightening, JoinsLegsOfOneDirectionAndOnlyThose) {
  const Route route{{{0.0, 0.0}, {1000.0, 500.0}, {2000.0, 1000.0}, {3000.0, 1000.0}, {2000.0, 1000.0}},
                    {true, false, false, false, true}};

  const Route joined = join_collinear(route);

  EXPECT_EQ(joined.points,
            (std::vector<geo::PlanePoint>{{0.0, 0.0}, {2000.0, 1000.0}, {3000.0, 1000.0}, {2000.0, 1000.0}}));
}

}  // namespace
}  // namespace floeplan::planning::cost::straightening_test

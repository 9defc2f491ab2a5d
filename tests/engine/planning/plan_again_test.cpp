#include <cmath>
#include <vector>

#include "engine/geo/geodesic.hpp"
#include "engine/planning/evaluate_route.hpp"
#include "engine/planning/plan_route.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning {
namespace {

using support::eastward_request;
using support::uniform;
using support::uniform_int;

/// The route as documents hold it (1e-7 degrees) or mission files (a ten-thousandth of a minute).
std::vector<geo::LonLat> written(const Plan& plan, double parts_of_a_degree) {
  const auto round = [&](double degrees) {
    return std::round(degrees * parts_of_a_degree) / parts_of_a_degree;
  };
  std::vector<geo::LonLat> route;
  for (const Waypoint& waypoint : plan.waypoints)
    route.push_back({round(waypoint.place.lon_deg), round(waypoint.place.lat_deg)});
  return route;
}

/// Icebergs strewn over the way, many of which a fast route just touches.
ocean::Environment strewn(std::mt19937_64& rng, const PlanRequest& request) {
  ocean::Environment environment;
  for (int i = uniform_int(rng, 1, 6); i > 0; --i) {
    const double along = uniform(rng, 0.25, 0.75);
    const geo::LonLat place{request.from.lon_deg + along * (request.to.lon_deg - request.from.lon_deg),
                            request.from.lat_deg + uniform(rng, -0.05, 0.05)};
    environment.icebergs.push_back(support::iceberg_at(place, uniform(rng, 20.0, 400.0)));
    environment.icebergs.back().observed = request.depart - core::Seconds{3600.0 * uniform(rng, 0.0, 20.0)};
  }
  return environment;
}

TEST(PlanAgain, APlanIsNotRefusedWhereItsRouteIsJudgedOnTheSameData) {
  int planned = 0;
  support::for_each_seed(20, [&](std::mt19937_64& rng) {
    PlanRequest request = eastward_request();
    const double lat_deg = uniform(rng, 35.0, 75.0);
    request.from.lat_deg = request.to.lat_deg = lat_deg;
    request.icebergs.margin = core::Metres{uniform(rng, 100.0, 5500.0)};
    request.icebergs.max_inflation = core::Metres{uniform(rng, 0.0, 1000.0)};
    request.icebergs.drift = uniform_int(rng, 0, 1) == 1;
    const ocean::Environment environment = strewn(rng, request);

    const auto found = plan_route(environment, request, {}, {});
    if (!found) return;  // an iceberg over start or goal
    ++planned;

    for (const double parts_of_a_degree : {1e7, 600'000.0}) {
      const auto again = evaluate_route(environment, written(*found, parts_of_a_degree), request);
      ASSERT_TRUE(again.has_value()) << again.error().explanation;
      EXPECT_NEAR(again->travel_time().count(), found->travel_time().count(),
                  1e-3 * found->travel_time().count());
    }
    EXPECT_GE(found->clearances.iceberg.value().value, request.icebergs.margin.value);
  });
  EXPECT_GT(planned, 10);
}

}  // namespace
}  // namespace floeplan::planning

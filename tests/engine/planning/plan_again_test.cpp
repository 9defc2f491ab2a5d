#include <cmath>
#include <vector>

#include "engine/geo/geodesic.hpp"
#include "engine/planning/evaluate_route.hpp"
#include "engine/planning/plan_route.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::plan_again_test {
namespace {

using support::eastward_request;
using support::uniform;
using support::uniform_int;

/// The route, rounded as in documents (1e-7 degrees) or in mission files (1e-4 minutes).
std::vector<geo::LonLat> written(const Plan& plan, double parts_of_a_degree) {
  const auto round = [&](double degrees) {
    return std::round(degrees * parts_of_a_degree) / parts_of_a_degree;
  };
  std::vector<geo::LonLat> route;
  for (const Waypoint& waypoint : plan.waypoints)
    route.push_back({round(waypoint.place.lon_deg), round(waypoint.place.lat_deg)});
  return route;
}

/// Icebergs scattered over the route. A fast route touches many of their discs.
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

/// A triangle or a quadrangle about the place.
geo::Polygon corners_about(std::mt19937_64& rng, geo::LonLat place, double size_deg) {
  geo::Polygon polygon;
  const int corners = uniform_int(rng, 3, 4);
  const double turned = uniform(rng, 0.0, 6.28);
  for (int i = 0; i < corners; ++i) {
    const double angle = turned + (i + uniform(rng, 0.0, 0.6)) * 6.28 / corners;
    polygon.outer.push_back({place.lon_deg + size_deg * std::cos(angle),
                             place.lat_deg + 0.36 * size_deg * std::sin(angle)});  // as long as wide at 69 N
  }
  return polygon;
}

/// Areas that are closed for a while, whose corners a fast route rounds; or an area to stay in with such a notch.
std::vector<ocean::Zone> timed_zones(std::mt19937_64& rng, const PlanRequest& request) {
  const auto in_force = [&](ocean::ZoneKind kind, geo::Polygon area) {
    return ocean::Zone{.name = "",
                       .kind = kind,
                       .area = std::move(area),
                       .from = request.depart - core::Seconds{3600.0 * uniform(rng, 0.0, 5.0)},
                       .until = request.depart + core::Seconds{3600.0 * uniform(rng, 8.0, 90.0)}};
  };
  const double lon = request.to.lon_deg - request.from.lon_deg;
  const auto on_the_way = [&](double share) {
    return geo::LonLat{request.from.lon_deg + share * lon, request.from.lat_deg + uniform(rng, -0.02, 0.02)};
  };
  std::vector<ocean::Zone> zones;
  if (uniform_int(rng, 0, 3) == 0) {
    geo::Polygon area{.outer = {{request.from.lon_deg - 0.3, request.from.lat_deg - 0.2},
                                {request.to.lon_deg + 0.3, request.from.lat_deg - 0.2},
                                {request.to.lon_deg + 0.3, request.from.lat_deg + 0.2},
                                {request.from.lon_deg - 0.3, request.from.lat_deg + 0.2}},
                      .holes = {}};
    area.holes.push_back(corners_about(rng, on_the_way(0.5), uniform(rng, 0.05, 0.2)).outer);
    zones.push_back(in_force(ocean::ZoneKind::stay_in, std::move(area)));
    return zones;
  }
  for (const double share : {0.3, 0.5, 0.7}) {
    if (!zones.empty() && uniform_int(rng, 0, 1) == 0) continue;
    zones.push_back(
        in_force(ocean::ZoneKind::no_go, corners_about(rng, on_the_way(share), uniform(rng, 0.03, 0.15))));
  }
  return zones;
}

TEST(PlanAgain, APlanRoundAreasThatAreClosedForAWhileIsTheSameWhereItIsWritten) {
  int planned = 0;
  support::for_each_seed(24, [&](std::mt19937_64& rng) {
    PlanRequest request = eastward_request();
    request.vehicle = *vehicle::find_profile("slocum-g3-200-thruster");
    request.energy.thruster = uniform_int(rng, 0, 1) == 0 ? ThrusterUse::on : ThrusterUse::off;
    request.spacing_along = core::Metres{uniform(rng, 4000.0, 7000.0)};
    request.optimality_gap = false;
    request.from.lat_deg = request.to.lat_deg = uniform(rng, 68.0, 70.0);
    request.zones = timed_zones(rng, request);
    ocean::Environment environment;
    const bool flows = uniform_int(rng, 0, 9) == 0;
    if (flows) {
      const double seed = uniform(rng, 0.0, 6.0);
      environment.currents = support::currents_from(
          [=](geo::LonLat p, double hour) {
            const double m_s = 0.1 * std::sin(seed + 9.0 * p.lon_deg + 20.0 * p.lat_deg + 0.2 * hour);
            return geo::VelocityEn{{m_s}, {0.5 * m_s}};
          },
          90);
    }

    const auto found = plan_route(environment, request, {}, {});
    if (!found) return;  // an area round start or goal
    ++planned;

    const auto again = evaluate_route(environment, written(*found, 1e7), request);
    ASSERT_TRUE(again.has_value()) << again.error().explanation();
    // In currents each leg is integrated in another plane, to the tolerance of an edge.
    const double agreement = flows ? 0.5 * request.edge_tolerance : 1e-6;
    EXPECT_NEAR(again->travel_time().count(), found->travel_time().count(),
                agreement * found->travel_time().count());
    const auto rounded = evaluate_route(environment, written(*found, 600'000.0), request);
    EXPECT_TRUE(rounded.has_value()) << "as mission files hold it: " << rounded.error().explanation();
  });
  EXPECT_GT(planned, 20);
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
      ASSERT_TRUE(again.has_value()) << again.error().explanation();
      EXPECT_NEAR(again->travel_time().count(), found->travel_time().count(),
                  1e-3 * found->travel_time().count());
    }
    EXPECT_GE(found->clearances.iceberg.value().value, request.icebergs.margin.value);
  });
  EXPECT_GT(planned, 10);
}

}  // namespace
}  // namespace floeplan::planning::plan_again_test

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/planning/find_isochrones.hpp"
#include "engine/planning/search/isochrone_search.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::reach_under_ice_test {
namespace {

using Direction = IsochroneRequest::Direction;

constexpr core::Seconds hour{3600.0};
constexpr double ice_edge_deg = -52.9;
constexpr double step_m = 500.0;
const geo::LocalProjection projection{{-53.0, 69.0}};

ocean::Environment solid_ice_east_of_the_edge() {
  return {.ice = support::ice_from(
              [](geo::LonLat place, double) { return place.lon_deg > ice_edge_deg + 1e-6 ? 1.0 : 0.0; },
              {0.0}, 1.0)};
}

IsochroneRequest reach_request(Direction direction, double hours, std::optional<double> bound_h) {
  IsochroneRequest request;
  request.direction = direction;
  request.place = {-53.0, 69.0};
  request.time =
      core::from_unix_seconds(support::sea_start_s) + (direction == Direction::to ? hours : 0.0) * hour;
  request.spans = {hours * hour};
  request.vehicle = *vehicle::find_profile("slocum-g3-200");
  request.spacing = core::Metres{step_m};
  if (bound_h) request.under_ice.max_time_without_surfacing = *bound_h * hour;
  return request;
}

double easternmost_m(const Isochrones& reach) {
  double east_m = -std::numeric_limits<double>::infinity();
  for (const geo::Polygon& polygon : reach.areas.front().polygons) {
    for (const geo::LonLat place : polygon.outer) east_m = std::max(east_m, projection.to_plane(place).x_m);
  }
  return east_m;
}

TEST(ReachUnderIce, GoesAsFarBelowTheIceAsTheBoundLetsEitherWay) {
  const ocean::Environment environment = solid_ice_east_of_the_edge();
  const double speed_m_s = vehicle::find_profile("slocum-g3-200")->speed_through_water.value;
  const double edge_m = projection.to_plane({ice_edge_deg, 69.0}).x_m;
  for (const Direction direction : {Direction::from, Direction::to}) {
    for (const double bound_h : {3.0, 6.0}) {
      const Isochrones bounded =
          find_isochrones(environment, reach_request(direction, 24.0, bound_h), {}, {}).value();

      const double below_ice_m = easternmost_m(bounded) - edge_m;
      const double most_m = bound_h * 3600.0 * speed_m_s;
      EXPECT_LE(below_ice_m, 1.001 * most_m + 600.0) << "the ice begins within a cell of its data";
      EXPECT_GE(below_ice_m, 0.98 * most_m - 2.0 * step_m);
      const double west_m = 24.0 * 3600.0 * speed_m_s;
      const Isochrones unbounded =
          find_isochrones(environment, reach_request(direction, 24.0, std::nullopt), {}, {}).value();
      EXPECT_GT(easternmost_m(unbounded), 0.97 * west_m);
    }
  }
}

TEST(ReachUnderIce, IsTheSameAsWithoutABoundThatNeverBinds) {
  const ocean::Environment environment = solid_ice_east_of_the_edge();
  for (const Direction direction : {Direction::from, Direction::to}) {
    const Isochrones bounded =
        find_isochrones(environment, reach_request(direction, 12.0, 1000.0), {}, {}).value();
    const Isochrones unbounded =
        find_isochrones(environment, reach_request(direction, 12.0, std::nullopt), {}, {}).value();

    EXPECT_NEAR(bounded.areas.front().area_m2, unbounded.areas.front().area_m2,
                1e-3 * unbounded.areas.front().area_m2);
  }
}

TEST(ReachUnderIce, KeepsMoreFromIceThatMayBeDeeper) {
  ocean::Environment environment = solid_ice_east_of_the_edge();
  environment.bathymetry = support::bathymetry_from([](geo::LonLat) { return 60.0; });
  IsochroneRequest request = reach_request(Direction::from, 12.0, std::nullopt);
  const double usual_m = easternmost_m(find_isochrones(environment, request, {}, {}).value());
  request.under_ice.margin_below_ice = core::Metres{45.0};

  const double careful_m = easternmost_m(find_isochrones(environment, request, {}, {}).value());

  EXPECT_GT(usual_m, 14'000.0);
  EXPECT_LT(careful_m, projection.to_plane({ice_edge_deg, 69.0}).x_m + 600.0) << "no room below the ice";
}

/// Patches of ice and open water, different ones for each seed.
ocean::Environment patches_of_ice(std::mt19937_64& rng) {
  const double phase = support::uniform(rng, 0.0, 6.28);
  const double other = support::uniform(rng, 0.0, 6.28);
  std::vector<double> hours;
  for (double hour = 0.0; hour <= 2400.0; hour += 150.0) hours.push_back(hour);
  return {.ice = support::ice_from(
              [&](geo::LonLat p, double) {
                return std::clamp(
                    0.45 + 0.5 * std::sin(9.0 * p.lon_deg + phase) + 0.4 * std::sin(25.0 * p.lat_deg + other),
                    0.0, 1.0);
              },
              hours, 1.0)};
}

PlanRequest bounded_voyage(core::Seconds bound) {
  PlanRequest request = support::eastward_request();
  request.under_ice.max_time_without_surfacing = bound;
  return request;
}

TEST(LegBack, ClosesAWayForTheSameVehiclesAsTheLegsForwards) {
  int kept = 0;
  int broken = 0;
  support::for_each_seed(60, [&](std::mt19937_64& rng) {
    ocean::Environment environment = patches_of_ice(rng);
    const double phase = support::uniform(rng, 0.0, 6.28);
    environment.currents = support::currents_from(
        [&](geo::LonLat p, double t) {
          return geo::VelocityEn{{0.15 * std::sin(4.0 * p.lat_deg + phase)}, {0.1 * std::cos(0.5 * t)}};
        },
        240);
    const PlanRequest request = bounded_voyage(support::uniform(rng, 8.0, 24.0) * hour);
    const cost::Sea sea{environment,
                        request,
                        projection,
                        {{-40'000.0, -40'000.0}, {40'000.0, 40'000.0}},
                        core::Metres{1000.0}};
    std::vector<geo::PlanePoint> way;
    for (int i = 0; i < 4; ++i) {
      way.push_back({support::uniform(rng, -15'000.0, 15'000.0), support::uniform(rng, -15'000.0, 15'000.0)});
    }

    constexpr core::Seconds depart =
        hour;  // times that come back differ a little, and before the epoch there are no data
    core::Seconds now = depart;
    core::Seconds since{0.0};
    bool keeps_forwards = true;
    for (std::size_t i = 1; i < way.size(); ++i) {
      if (keeps_forwards) {
        const auto leg = sea.leg(way[i - 1], way[i], now, since);
        keeps_forwards = leg.has_value();
        if (leg) since = leg->since_surfacing;
      }
      now += sea.with({.bounds_surfacing = false}).leg_time(way[i - 1], way[i], now).value();
    }
    core::Seconds until{0.0};
    bool keeps_backwards = true;
    for (std::size_t i = way.size() - 1; i > 0 && keeps_backwards; --i) {
      const auto leg = sea.leg_back(way[i - 1], way[i], now, until, core::Seconds{-INFINITY});
      keeps_backwards = leg.has_value();
      if (!leg) break;
      now -= leg->time;
      until = leg->until_surfacing;
    }

    EXPECT_EQ(keeps_forwards, keeps_backwards);
    EXPECT_TRUE(!keeps_backwards || std::abs((now - depart).count()) < 60.0);
    ++(keeps_forwards ? kept : broken);
  });
  EXPECT_GT(kept, 10);
  EXPECT_GT(broken, 10);
}

/// The least time since a possible surfacing at each vertex over all walks from the start: in still water under ice
/// that does not change, a vertex can be reached at all, and the start from it, if and only if this is finite.
std::vector<double> least_since(const cost::Sea& sea, const search::OpenGrid& open) {
  constexpr double never = std::numeric_limits<double>::infinity();
  std::vector<double> least(open.graph.size(), never);
  least[open.grid.start] = 0.0;
  for (bool changed = true; changed;) {
    changed = false;
    for (graph::Vertex v = 0; v < open.graph.size(); ++v) {
      if (least[v] == never) continue;
      open.graph.for_each_edge(v, [&](const graph::Edge& edge) {
        const auto leg = sea.leg(open.grid.point(v), open.grid.point(edge.head), core::Seconds{0.0},
                                 core::Seconds{least[v]});
        if (!leg || !(leg->since_surfacing.count() < least[edge.head] - 1e-9)) return;
        least[edge.head] = leg->since_surfacing.count();
        changed = true;
      });
    }
  }
  return least;
}

TEST(ReachSearch, ComesWhereAnyWalkDoesThatKeepsABoundShorterByATwentieth) {
  constexpr core::Seconds known = 2400.0 * hour;  // of the ice
  int reached_vertices = 0;
  int closed_vertices = 0;
  support::for_each_seed(20, [&](std::mt19937_64& rng) {
    const ocean::Environment environment = patches_of_ice(rng);
    const core::Seconds bound = support::uniform(rng, 6.0, 16.0) * hour;
    cost::RouteGrid grid = cost::lay_grid({-30'000.0, 0.0}, {30'000.0, 0.0},
                                          {core::Metres{6000.0}, core::Metres{6000.0}}, {0.5, 0.5});
    grid.goal = grid.start;
    const plane::PlaneBox area = grid.bounds().grown(2000.0);
    const PlanRequest request = bounded_voyage(bound);
    const cost::Sea sea{environment, request, projection, area, core::Metres{1000.0}};
    const PlanRequest stricter = bounded_voyage(0.95 * bound);
    const cost::Sea strict_sea{environment, stricter, projection, area, core::Metres{1000.0}};
    const search::OpenGrid open = search::open_grid(sea.domain(), grid, 2, {});
    const std::vector<double> possible = least_since(sea, open);
    const std::vector<double> strictly_possible = least_since(strict_sea, open);

    for (const Direction direction : {Direction::from, Direction::to}) {
      const core::Seconds begin = direction == Direction::from ? core::Seconds{0.0} : -known;
      const search::Reached reached =
          search::find_reached(sea, open, direction, begin, begin + known, {}, {});

      for (graph::Vertex v = 0; v < open.graph.size(); ++v) {
        const bool is_reached = std::isfinite(reached.earliest_s(v));
        EXPECT_TRUE(!is_reached || std::isfinite(possible[v])) << v;
        EXPECT_TRUE(is_reached || !std::isfinite(strictly_possible[v])) << v;
        ++(is_reached ? reached_vertices : closed_vertices);
        EXPECT_TRUE(std::ranges::is_sorted(reached.at(v), {}, &search::Presence::when));
      }
    }
  });
  EXPECT_GT(reached_vertices, 500);
  EXPECT_GT(closed_vertices, 500);
}

}  // namespace
}  // namespace floeplan::planning::reach_under_ice_test

#include "engine/planning/search/route_search.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/graph/time_dependent_astar.hpp"
#include "engine/planning/search/chart.hpp"
#include "engine/planning/search/grid/grid_travel.hpp"
#include "engine/planning/search/voyage_grids.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::search::route_search_test {
namespace {

constexpr core::Seconds at_once{0.0};
constexpr double gap_deg = 0.03;

/// A wall from south to north across all grids, with a gap at some latitude or without one.
std::vector<ocean::Zone> wall(std::optional<double> gap_lat_deg) {
  const auto part = [](double south, double north) {
    return ocean::Zone{
        .name = "",
        .kind = ocean::ZoneKind::no_go,
        .area = {.outer = {{-53.02, south}, {-52.98, south}, {-52.98, north}, {-53.02, north}}, .holes = {}},
        .from = {},
        .until = {}};
  };
  if (!gap_lat_deg) return {part(67.0, 71.0)};
  return {part(67.0, *gap_lat_deg), part(*gap_lat_deg + gap_deg, 71.0)};
}

ocean::Environment tide(std::mt19937_64& rng) {
  const double phase = support::uniform(rng, 0.0, 6.28);
  return {.currents = support::currents_from(
              [&](geo::LonLat p, double hour) {
                return geo::VelocityEn{{0.2 * std::cos(hour / 2.0 + phase)},
                                       {0.2 * std::sin(hour / 3.0 + 4.0 * p.lon_deg)}};
              },
              200)};
}

/// Law: a wall that always stands closes the way exactly where an exact search over the whole grid finds none. It is
/// found without timing legs all over the grid.
TEST(SearchRoute, FindsAWallThatAlwaysStandsWithoutTimingTheLegsBeforeIt) {
  int closed = 0;
  int open_ways = 0;
  support::for_each_seed(12, [&](std::mt19937_64& rng) {
    PlanRequest request = support::eastward_request();
    request.spacing_along = core::Metres{1000.0};
    const bool has_gap = support::uniform_int(rng, 0, 1) == 1;
    request.zones = wall(has_gap ? std::optional{support::uniform(rng, 68.8, 69.2)} : std::nullopt);
    const ocean::Environment environment = tide(rng);
    const auto chart = draw_chart(environment, request, cost::first_reach, {});
    ASSERT_TRUE(chart.has_value());
    const auto grids = open_grids(chart->sea, chart->layout.grids, request.sectors, {});
    const OpenGrid& open = grids.front();
    const graph::Query query{open.grid.start, open.grid.goal, at_once};
    const graph::SearchTree exact =
        graph::find_earliest_arrivals(open.graph, query, GridTravelTime{chart->sea, open.grid}, {});

    const RouteSearch found = search_route(chart->sea, open, request, at_once, {}, [](double) {});

    ASSERT_EQ(found.path.empty(), !exact.is_reached(open.grid.goal));
    if (!found.path.empty()) {
      EXPECT_NEAR(found.arrival.count(), exact.arrival_s(open.grid.goal), 120.0);
      ++open_ways;
      return;
    }
    ++closed;
    EXPECT_GT(std::ranges::count(found.closed_at_nearest, motion::EdgeClosed::in_zone), 0);
    graph::Vertex nearest = 0;
    while (geo::distance_m(open.grid.point(nearest), found.nearest) > 0.0) ++nearest;
    EXPECT_NEAR(found.nearest_arrival.count(), exact.arrival_s(nearest), 120.0);
    EXPECT_LT(found.statistics.edge_evaluations, exact.counters.edge_evaluations / 2);
  });
  EXPECT_GE(closed, 3);
  EXPECT_GE(open_ways, 3);
}

}  // namespace
}  // namespace floeplan::planning::search::route_search_test

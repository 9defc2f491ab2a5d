#include "engine/planning/search/surfacing/surfacing_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/planning/cost/route_cost.hpp"
#include "engine/planning/search/chart.hpp"
#include "engine/planning/search/route_search.hpp"
#include "engine/planning/search/surfacing/surfacing_reach.hpp"
#include "tests/engine/planning/drifting_bergs.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::search::surfacing_search_test {
namespace {

const geo::LocalProjection projection{{-53.0, 69.0}};
constexpr double never = std::numeric_limits<double>::infinity();

/// A few columns and rows 8 km apart, from the west to the east.
cost::RouteGrid small_grid(int nx, int ny) {
  cost::RouteGrid grid;
  grid.origin = {-4000.0 * (nx - 1), -4000.0 * (ny - 1)};
  grid.along = {8000.0, 0.0};
  grid.across = {0.0, 8000.0};
  grid.nx = nx;
  grid.ny = ny;
  grid.start = static_cast<graph::Vertex>((ny / 2) * nx);
  grid.goal = grid.start + static_cast<graph::Vertex>(nx - 1);
  return grid;
}

PlanRequest bounded_request(double bound_h) {
  PlanRequest request = support::eastward_request();
  request.sectors = 1;
  request.under_ice.max_time_without_surfacing = core::Seconds{3600.0 * bound_h};
  return request;
}

/// Whether any walk over the grid, however it turns and returns, is at the goal before `latest`.
class AllWalks {
 public:
  AllWalks(const cost::Sea& sea, const OpenGrid& open, double latest_s)
      : sea_{sea}, open_{open}, latest_s_{latest_s} {}

  bool reach_goal_from(graph::Vertex v, double arrival_s, double since_s) {
    const geo::PlanePoint here = open_.grid.point(v);
    if (arrival_s + sea_.least_time(here, open_.grid.point(open_.grid.goal)).count() >= latest_s_)
      return false;
    if (v == open_.grid.goal) return true;
    bool reached = false;
    open_.graph.for_each_edge(v, [&](const graph::Edge& edge) {
      if (reached) return;
      const auto leg =
          sea_.leg(here, open_.grid.point(edge.head), core::Seconds{arrival_s}, core::Seconds{since_s});
      if (leg)
        reached = reach_goal_from(edge.head, arrival_s + leg->time.count(), leg->since_surfacing.count());
    });
    return reached;
  }

 private:
  const cost::Sea& sea_;
  const OpenGrid& open_;
  double latest_s_;
};

/// The least time since a possible surfacing at each vertex, over all walks: in still water under ice that does not
/// change, a vertex can be reached at all if and only if this is finite.
std::vector<double> least_since(const cost::Sea& sea, const OpenGrid& open) {
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

TEST(SurfacingSearch, FindsAnArrivalAsEarlyAsAnyWalkThatKeepsABoundShorterByAHundredth) {
  int found = 0;
  int refused = 0;
  support::for_each_seed(40, [&](std::mt19937_64& rng) {
    const double phase = support::uniform(rng, 0.0, 6.28);
    const double other = support::uniform(rng, 0.0, 6.28);
    const ocean::Environment environment{.ice = support::ice_from(
                                             [&](geo::LonLat p, double) {
                                               return std::clamp(0.45 +
                                                                     0.5 * std::sin(9.0 * p.lon_deg + phase) +
                                                                     0.4 * std::sin(25.0 * p.lat_deg + other),
                                                                 0.0, 1.0);
                                             },
                                             {0.0}, 1.0)};
    const PlanRequest request = bounded_request(support::uniform(rng, 6.0, 20.0));
    const cost::RouteGrid grid = small_grid(5, 4);
    const cost::Sea sea{environment, request, projection, grid.bounds().grown(2000.0), core::Metres{1000.0}};
    const OpenGrid open = open_grid(sea.domain(), grid, request.sectors, {});

    const RouteSearch search = search_route(sea, open, request, core::Seconds{0.0}, {}, [](double) {});

    PlanRequest stricter = request;
    *stricter.under_ice.max_time_without_surfacing *= 0.99;
    const cost::Sea strict_sea{environment, stricter, projection, grid.bounds().grown(2000.0),
                               core::Metres{1000.0}};
    const bool possible = least_since(sea, open)[grid.goal] < never;
    const bool strictly_possible = least_since(strict_sea, open)[grid.goal] < never;
    if (search.path.empty()) {
      ASSERT_FALSE(strictly_possible);
      ++refused;
      return;
    }
    ASSERT_TRUE(possible);
    ++found;
    const auto arrivals = cost::arrivals_along(sea, search.path, core::Seconds{0.0});
    ASSERT_TRUE(arrivals) << "the bound holds along the whole way";
    const double arrival_s = arrivals->back().count();
    EXPECT_NEAR(search.arrival.count(), arrival_s, 1e-3);
    EXPECT_FALSE((AllWalks{strict_sea, open, (1.0 - sea.edge_tolerance()) * arrival_s - 0.1}.reach_goal_from(
        grid.start, 0.0, 0.0)));
  });
  EXPECT_GT(found, 10);
  EXPECT_GT(refused, 2);
}

TEST(SurfacingSearch, GoesBackAndForthToOpenWaterWhenNothingElseKeepsTheBound) {
  // A corridor under ice with open water beside its middle: the way east visits it and returns.
  const ocean::Environment environment{.ice = support::ice_from(
                                           [](geo::LonLat p, double) {
                                             const bool start = p.lon_deg < -53.35;
                                             const bool patch =
                                                 std::abs(p.lon_deg + 53.0) < 0.12 && p.lat_deg > 69.04;
                                             return start || patch ? 0.0 : 0.9;
                                           },
                                           {0.0}, 1.0)};
  const cost::RouteGrid grid = small_grid(5, 3);
  const auto arrival_h = [&](double bound_h) {
    const PlanRequest request = bounded_request(bound_h);
    const cost::Sea sea{environment, request, projection, grid.bounds().grown(2000.0), core::Metres{500.0}};
    const RouteSearch search = search_route(sea, open_grid(sea.domain(), grid, 1, {}), request,
                                            core::Seconds{0.0}, {}, [](double) {});
    const auto arrivals = cost::arrivals_along(sea, search.path, core::Seconds{0.0});
    return search.path.empty() || !arrivals ? never : arrivals->back().count() / 3600.0;
  };

  const double straight = arrival_h(100.0);
  EXPECT_NEAR(straight, 32'000.0 / 0.35 / 3600.0, 0.2);
  EXPECT_GT(arrival_h(20.0), straight + 1.0);
  EXPECT_LT(arrival_h(20.0), never);
  EXPECT_EQ(arrival_h(5.0), never);
}

TEST(SurfacingSearch, SaysThatTheLastSurfacingLiesTooFarBack) {
  const ocean::Environment environment{
      .ice = support::ice_from([](geo::LonLat, double) { return 0.9; }, {0.0}, 1.0)};
  const PlanRequest request = bounded_request(3.0);
  const cost::RouteGrid grid = small_grid(5, 3);
  const cost::Sea sea{environment, request, projection, grid.bounds().grown(2000.0), core::Metres{1000.0}};

  const RouteSearch search =
      search_route(sea, open_grid(sea.domain(), grid, 1, {}), request, core::Seconds{0.0}, {}, [](double) {});

  EXPECT_TRUE(search.path.empty());
  EXPECT_GT(std::ranges::count(search.closed_at_nearest, motion::EdgeClosed::no_surfacing), 0);
}

TEST(SurfacingSearch, TakesTheBestWayOfAllWhereThatKeepsTheBound) {
  // Eddies, and a tongue of ice to the north of the route.
  const ocean::Environment environment{
      .currents = support::currents_from(
          [](geo::LonLat p, double hour) {
            return geo::VelocityEn{{0.1 * std::sin(9.0 * p.lat_deg + 0.1 * hour)},
                                   {0.1 * std::cos(7.0 * p.lon_deg)}};
          },
          96),
      .ice =
          support::ice_from([](geo::LonLat p, double) { return p.lat_deg > 69.05 ? 0.9 : 0.0; }, {0.0}, 1.0)};
  const cost::RouteGrid grid = small_grid(6, 6);
  const auto search_within = [&](double bound_h) {
    const PlanRequest request = bounded_request(bound_h);
    const cost::Sea sea{environment, request, projection, grid.bounds().grown(2000.0), core::Metres{1000.0}};
    return search_route(sea, open_grid(sea.domain(), grid, 1, {}), request, core::Seconds{0.0}, {},
                        [](double) {});
  };

  const RouteSearch unhindered = search_within(1000.0);
  const RouteSearch within_three_hours = search_within(3.0);
  ASSERT_FALSE(unhindered.path.empty());
  EXPECT_EQ(within_three_hours.arrival, unhindered.arrival);
  EXPECT_EQ(within_three_hours.statistics.expansions, unhindered.statistics.expansions);
}

TEST(SurfacingSearch, FindsTheWayPastABergThatLeavesTheGapLater) {
  PlanRequest request = bounded_request(1000.0);
  request.sectors = 2;
  request.spacing_along = core::Metres{2000.0};
  request.icebergs.margin = core::Metres{5500.0};
  request.icebergs.max_inflation = core::Metres{0.0};
  ocean::Environment environment{
      .bathymetry = wall_with_a_gap(),
      .ice = support::ice_from([](geo::LonLat, double) { return 0.0; }, {0.0}, 1.0)};
  environment.icebergs = {drifting_berg({-53.2, 69.0}, 100.0, 0.12, 90.0)};
  const auto chart = draw_chart(environment, request, cost::first_reach, {});
  ASSERT_TRUE(chart);
  const OpenGrid open = open_grid(chart->sea.domain(), chart->layout.grids.front(), request.sectors, {});

  const RouteSearch of_all = search_route(chart->sea, open, request, core::Seconds{0.0}, {}, [](double) {});
  const RouteSearch bounded =
      search_with_surfacings(chart->sea, open, core::Seconds{0.0}, core::Seconds{0.0}, {}, [](double) {});

  ASSERT_FALSE(of_all.path.empty());
  ASSERT_FALSE(bounded.path.empty());
  EXPECT_NEAR(bounded.arrival.count(), of_all.arrival.count(), 0.02 * of_all.arrival.count());
}

TEST(SurfacingSearch, ReturnsTheBestWayItKnowsWhenItIsCutShort) {
  // Patches of open water: many routes lead to each place.
  const ocean::Environment environment{.ice = support::ice_from(
                                           [](geo::LonLat p, double) {
                                             return std::clamp(0.45 + 0.5 * std::sin(9.0 * p.lon_deg) +
                                                                   0.4 * std::sin(25.0 * p.lat_deg),
                                                               0.0, 1.0);
                                           },
                                           {0.0}, 1.0)};
  const PlanRequest request = bounded_request(20.0);
  cost::RouteGrid grid = small_grid(25, 25);
  grid.along.x_m /= 4.0;
  grid.across.y_m /= 4.0;
  const cost::Sea sea{environment, request, projection, grid.bounds().grown(2000.0), core::Metres{1000.0}};
  const OpenGrid open = open_grid(sea.domain(), grid, 2, {});
  const auto search_among = [&](std::size_t labels) {
    return search_with_surfacings(sea, open, core::Seconds{0.0}, core::Seconds{0.0}, {}, [](double) {},
                                  {labels, labels});
  };

  const RouteSearch whole = search_among(100'000);
  ASSERT_FALSE(whole.path.empty());
  EXPECT_FALSE(whole.statistics.cut_short);
  int with_a_way = 0;
  for (std::size_t labels = 100; labels < 20'000; labels *= 2) {
    const RouteSearch part = search_among(labels);
    if (part.path.empty()) continue;
    ++with_a_way;
    EXPECT_TRUE(cost::arrivals_along(sea, part.path, core::Seconds{0.0}));
    EXPECT_GE(part.arrival.count(), whole.arrival.count() - 1e-6);
  }
  EXPECT_GT(with_a_way, 2);
}

TEST(SurfacingSearch, FindsAnyWayBeforeItLooksForABetterOne) {
  // A block of ice on the straight route, too wide for the bound, with bergs that drift about it: the route leads round.
  ocean::Environment environment{
      .ice = support::ice_from(
          [](geo::LonLat p, double) {
            return std::abs(p.lon_deg + 53.0) < 0.3 && std::abs(p.lat_deg - 69.0) < 0.15 ? 0.9 : 0.0;
          },
          {0.0, 120.0, 240.0}, 1.0)};
  for (const double lat_deg : {68.82, 69.18})
    environment.icebergs.push_back(drifting_berg({-53.0, lat_deg}, 100.0, 0.05, 90.0));
  const PlanRequest request = bounded_request(6.0);
  cost::RouteGrid grid = small_grid(41, 31);
  grid.along.x_m /= 4.0;
  grid.across.y_m /= 4.0;
  grid.origin = {-1000.0 * 40, -1000.0 * 30};
  const cost::Sea sea{environment, request, projection, grid.bounds().grown(5000.0), core::Metres{1000.0}};
  const OpenGrid open = open_grid(sea.domain(), grid, 2, {});
  ASSERT_TRUE(sea.domain().closures().any_timed());
  const auto search_with = [&](SurfacingBudget budget) {
    return search_with_surfacings(
        sea, open, core::Seconds{0.0}, core::Seconds{0.0}, {}, [](double) {}, budget);
  };

  const RouteSearch any = search_with({.any_way = 20'000, .best_way = 10});

  ASSERT_FALSE(any.path.empty());
  EXPECT_TRUE(any.statistics.cut_short) << "a better way was looked for with ten labels only";
  const auto arrivals = cost::arrivals_along(sea, any.path, core::Seconds{0.0});
  ASSERT_TRUE(arrivals) << "the bound holds along the whole way";
  EXPECT_NEAR(any.arrival.count(), arrivals->back().count(), 1e-3);
  const RouteSearch best = search_with({.any_way = 20'000, .best_way = 200'000});
  EXPECT_LE(best.arrival.count(), any.arrival.count());
  EXPECT_GT(best.arrival.count(), 0.8 * any.arrival.count());
}

TEST(SurfacingSearch, ProvesThatNoWayKeepsTheBound) {
  // A belt of ice from north to south that takes more than a day to cross.
  const ocean::Environment environment{
      .ice = support::ice_from(
          [](geo::LonLat p, double) { return std::abs(p.lon_deg + 53.0) < 0.5 ? 0.9 : 0.0; },
          {0.0, 120.0, 240.0}, 1.0)};
  cost::RouteGrid grid = small_grid(41, 31);
  grid.along.x_m /= 4.0;
  grid.across.y_m /= 4.0;
  grid.origin = {-1000.0 * 40, -1000.0 * 30};
  for (const double bound_h : {3.0, 60.0}) {
    const PlanRequest request = bounded_request(bound_h);
    const cost::Sea sea{environment, request, projection, grid.bounds().grown(2000.0), core::Metres{1000.0}};
    const OpenGrid open = open_grid(sea.domain(), grid, 2, {});
    const SurfacingReach reach{sea, open, core::Seconds{0.0}, core::Seconds{0.0}, {}};
    EXPECT_EQ(reach.has_hope(), bound_h > 20.0);

    const RouteSearch search =
        search_with_surfacings(sea, open, core::Seconds{0.0}, core::Seconds{0.0}, {}, [](double) {});

    EXPECT_EQ(search.path.empty(), bound_h < 20.0);
    EXPECT_FALSE(search.statistics.cut_short) << "a proof, not the end of the memory";
    if (!search.path.empty()) continue;
    EXPECT_TRUE(std::ranges::count(search.closed_at_nearest, motion::EdgeClosed::no_surfacing) > 0);
    EXPECT_GT(search.nearest.x_m, -30'000.0) << "it shows the edge of the belt, not the start";
  }
}

}  // namespace
}  // namespace floeplan::planning::search::surfacing_search_test

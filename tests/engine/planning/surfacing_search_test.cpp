#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/planning/route_cost.hpp"
#include "engine/planning/route_search.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning {
namespace {

const geo::LocalProjection projection{{-53.0, 69.0}};
constexpr double never = std::numeric_limits<double>::infinity();

/// A few columns and rows 8 km apart, from the west to the east.
RouteGrid small_grid(int nx, int ny) {
  RouteGrid grid;
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
  AllWalks(const Sea& sea, const OpenGrid& open, double latest_s)
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
  const Sea& sea_;
  const OpenGrid& open_;
  double latest_s_;
};

/// The least time since a possible surfacing at each vertex, over all walks: in still water under ice that does not
/// change, a vertex can be reached at all if and only if this is finite.
std::vector<double> least_since(const Sea& sea, const OpenGrid& open) {
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

TEST(SurfacingSearch, FindsTheEarliestArrivalOfAllWalksThatKeepTheBound) {
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
    const RouteGrid grid = small_grid(5, 4);
    const Sea sea{environment, request, projection, grid.bounds().grown(2000.0), core::Metres{1000.0}};
    const OpenGrid open = open_grid(sea, grid, request.sectors, {});

    const RouteSearch search = search_route(sea, open, request, core::Seconds{0.0}, {}, [](double) {});

    const bool possible = least_since(sea, open)[grid.goal] < never;
    ASSERT_EQ(!search.path.empty(), possible);
    if (!possible) {
      ++refused;
      return;
    }
    ++found;
    const auto arrivals = arrivals_along(sea, search.path, core::Seconds{0.0});
    ASSERT_TRUE(arrivals) << "the bound holds along the whole way";
    const double arrival_s = arrivals->back().count();
    EXPECT_FALSE((AllWalks{sea, open, arrival_s - 0.1}.reach_goal_from(grid.start, 0.0, 0.0)));
  });
  EXPECT_GT(found, 10);
  EXPECT_GT(refused, 2);
}

TEST(SurfacingSearch, GoesBackAndForthToOpenWaterWhenNothingElseKeepsTheBound) {
  // A corridor under ice with open water beside its middle: the way east leads there and back.
  const ocean::Environment environment{.ice = support::ice_from(
                                           [](geo::LonLat p, double) {
                                             const bool start = p.lon_deg < -53.35;
                                             const bool patch =
                                                 std::abs(p.lon_deg + 53.0) < 0.12 && p.lat_deg > 69.04;
                                             return start || patch ? 0.0 : 0.9;
                                           },
                                           {0.0}, 1.0)};
  const RouteGrid grid = small_grid(5, 3);
  const auto arrival_h = [&](double bound_h) {
    const PlanRequest request = bounded_request(bound_h);
    const Sea sea{environment, request, projection, grid.bounds().grown(2000.0), core::Metres{500.0}};
    const RouteSearch search =
        search_route(sea, open_grid(sea, grid, 1, {}), request, core::Seconds{0.0}, {}, [](double) {});
    const auto arrivals = arrivals_along(sea, search.path, core::Seconds{0.0});
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
  const RouteGrid grid = small_grid(5, 3);
  const Sea sea{environment, request, projection, grid.bounds().grown(2000.0), core::Metres{1000.0}};

  const RouteSearch search =
      search_route(sea, open_grid(sea, grid, 1, {}), request, core::Seconds{0.0}, {}, [](double) {});

  EXPECT_TRUE(search.path.empty());
  EXPECT_GT(std::ranges::count(search.closed_at_nearest, motion::EdgeClosed::no_surfacing), 0);
}

}  // namespace
}  // namespace floeplan::planning

#include "engine/planning/search/bounds/foresight.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "engine/graph/time_dependent_astar.hpp"
#include "engine/planning/cost/route_cost.hpp"
#include "engine/planning/search/route_search.hpp"
#include "tests/engine/planning/search/bounds/foresight_waters.hpp"

namespace floeplan::planning::search::foresight_test {
namespace {

using graph::Edge;
using graph::SearchTree;
using graph::Vertex;

TEST(Foresight, LeastTimeIsNeverMoreThanTheLegTakes) {
  support::for_each_seed(15, [](std::mt19937_64& rng) {
    const Waters waters{random_environment(rng), support::uniform(rng, 500.0, 3000.0)};
    Foresight foresight{waters.sea, waters.open};
    ASSERT_TRUE(foresight.is_useful());
    for (int i = 0; i < 40; ++i) {
      const core::Seconds depart{support::uniform(rng, 0.0, 4e5)};
      waters.open.graph.for_each_edge(random_vertex(rng, waters.open), [&](const Edge& edge) {
        const auto time =
            waters.sea.leg_time(waters.grid.point(edge.tail), waters.grid.point(edge.head), depart);
        if (time) {
          EXPECT_LE(foresight.least_time(edge, depart).count(), time->count());
        }
      });
    }
  });
}

TEST(Foresight, SaysOfNoVertexThatItIsOfNoUseFromWhichTheGoalIsReachedInTime) {
  support::for_each_seed(6, [](std::mt19937_64& rng) {
    const Waters waters{random_environment(rng)};
    const core::Seconds depart{support::uniform(rng, 0.0, 40'000.0)};
    const GridTravelTime exact{waters.sea, waters.grid};
    const SearchTree all = graph::find_earliest_arrivals(
        waters.open.graph, graph::Query{waters.grid.start, {}, depart}, exact, {});
    if (!all.is_reached(waters.grid.goal)) return;
    const core::Seconds arrive{all.arrival_s(waters.grid.goal)};
    Foresight foresight{waters.sea, waters.open};
    const SearchTree& until_when = foresight.until_when_of_use(depart, arrive, {});

    for (int i = 0; i < 12; ++i) {
      const Vertex v = random_vertex(rng, waters.open);
      const double later_s = std::max(all.arrival_s(v), 1.0 - until_when.arrival_s(v));
      if (!std::isfinite(later_s)) continue;
      const SearchTree onward = graph::find_earliest_arrivals(
          waters.open.graph, graph::Query{v, waters.grid.goal, core::Seconds{later_s}}, exact, {});
      if (v != waters.grid.goal) {
        EXPECT_GT(onward.arrival_s(waters.grid.goal), arrive.count());
      }
    }
  });
}

TEST(FavourableBounds, NeverExceedTheTimesOfAVehicle) {
  double nearest = 0.0;
  support::for_each_seed(4, [&](std::mt19937_64& rng) {
    const Waters waters{random_environment(rng)};
    const FavourableBounds bounds{waters.sea, waters.open, {}};
    const core::Seconds depart{support::uniform(rng, 0.0, 40'000.0)};
    const GridTravelTime exact{waters.sea, waters.grid};
    const auto arrivals_from = [&](Vertex start) {
      return graph::find_earliest_arrivals(waters.open.graph, graph::Query{start, {}, depart}, exact, {});
    };
    const SearchTree from_start = arrivals_from(waters.grid.start);
    for (Vertex v = 0; v < waters.open.graph.size(); ++v) {
      if (!from_start.is_reached(v)) continue;
      EXPECT_LE(bounds.from_start.remaining(v).count(), from_start.arrival_s(v) - depart.count());
    }
    for (int i = 0; i < 4; ++i) {
      const Vertex v = random_vertex(rng, waters.open);
      const double time_s = arrivals_from(v).arrival_s(waters.grid.goal) - depart.count();
      EXPECT_LE(bounds.to_goal.remaining(v).count(), time_s);
      if (v != waters.grid.goal) nearest = std::max(nearest, bounds.to_goal.remaining(v).count() / time_s);
    }
    EXPECT_NEAR(bounds.to_goal.remaining(waters.grid.start).count(),
                bounds.from_start.remaining(waters.grid.goal).count(), 1e-6);
  });
  EXPECT_GT(nearest, 0.7) << "it is of use";
}

TEST(SearchRoute, FindsWithForesightWhatTheLabelCorrectingSearchFinds) {
  std::int64_t expanded = 0;
  std::int64_t expanded_by_all = 0;
  support::for_each_seed(12, [&](std::mt19937_64& rng) {
    Waters waters{random_environment(rng)};
    // The search for holds is the same with every method, so the vehicle never holds here.
    const cost::Sea moving = waters.sea.with({.holds = false});
    const core::Seconds depart{support::uniform(rng, 0.0, 40'000.0)};
    const auto found = [&](Method method) {
      waters.request.method = method;
      return search_route(moving, waters.open, waters.request, depart, {}, [](double) {});
    };
    const RouteSearch tve = found(Method::tve);
    if (tve.statistics.reinsertions > 0) return;  // FIFO is broken: only TVE goes back to settled vertices
    for (const Method method : {Method::dijkstra, Method::astar}) {
      const RouteSearch search = found(method);
      ASSERT_EQ(search.path.empty(), tve.path.empty());
      const auto end = [&](const RouteSearch& route) {
        const auto arrivals = cost::arrivals_along(moving, route.path, depart);
        return arrivals ? arrivals->back().count() : 0.0;
      };
      EXPECT_NEAR(end(search), end(tve), 1e-9 * end(tve));
      EXPECT_LE(search.statistics.expansions, tve.statistics.expansions);
      expanded += search.statistics.expansions;
      expanded_by_all += tve.statistics.expansions;
    }
  });
  EXPECT_LT(2 * expanded, expanded_by_all);
}

TEST(Foresight, IsOfNoUseWhereDataAreMuchFinerThanTheGrid) {
  const Waters coarse{{.currents = support::currents_from(
                           [](geo::LonLat, double) { return geo::VelocityEn{{0.1}, {0.0}}; }, 2)},
                      24'000.0};
  EXPECT_FALSE((Foresight{coarse.sea, coarse.open}.is_useful()));
}

TEST(Foresight, SweepsByTheStraightBoundWhereItIsOfNoUse) {
  const Waters coarse{{.currents = support::currents_from(
                           [](geo::LonLat, double) { return geo::VelocityEn{{0.1}, {0.0}}; }, 48)},
                      24'000.0};
  Foresight foresight{coarse.sea, coarse.open};
  ASSERT_FALSE(foresight.is_useful());
  const core::Seconds late{48.0 * 3600.0};

  const graph::SearchTree earliest = foresight.sweep_forth(core::Seconds{0.0}, late, {});
  const graph::SearchTree until_when = foresight.sweep_back(core::Seconds{0.0}, late, {}, earliest);

  const cost::RouteGrid& grid = coarse.open.grid;
  const core::Seconds least = coarse.sea.least_time(grid.point(grid.start), grid.point(grid.goal));
  ASSERT_TRUE(earliest.is_reached(grid.goal));
  EXPECT_GE(earliest.arrival_s(grid.goal), least.count() - 1.0);
  EXPECT_LE(-until_when.arrival_s(grid.start), late.count() - least.count() + 1.0);
}

TEST(Foresight, StopsWhenAsked) {
  const Waters waters{{}, 250.0};
  Foresight foresight{waters.sea, waters.open};
  std::stop_source source;
  source.request_stop();

  EXPECT_TRUE(foresight.likely_way(core::Seconds{0.0}, source.get_token(), {}).empty());
  EXPECT_TRUE(
      foresight.until_when_of_use(core::Seconds{0.0}, core::Seconds{1e6}, source.get_token()).stopped);
}

}  // namespace
}  // namespace floeplan::planning::search::foresight_test

#include "engine/graph/nearest_goal_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "engine/graph/time_dependent_astar.hpp"
#include "tests/support/property.hpp"

namespace floeplan::graph::nearest_goal_search_test {
namespace {

TEST(NearestGoalSearch, FindsTheGoalThatTheFullSearchReachesFirst) {
  support::for_each_seed(100, [](std::mt19937_64& rng) {
    const GridGraph graph{9, 7, 2};
    std::vector<double> cost(graph.size());
    std::vector<bool> goal(graph.size());
    for (double& value : cost) value = support::uniform(rng, 1.0, 10.0);
    for (std::size_t v = 0; v < goal.size(); ++v) goal[v] = support::uniform_int(rng, 0, 12) == 0;
    const auto travel_time = [&](const Edge& edge, core::Seconds, core::Seconds) {
      return std::optional{core::Seconds{cost[edge.tail] + cost[edge.head]}};
    };
    const core::Seconds latest{support::uniform(rng, 5.0, 40.0)};
    const auto source = static_cast<Vertex>(support::uniform_int(rng, 0, 62));

    const NearestGoal found = find_nearest_goal(graph, source, core::Seconds{0.0}, latest, travel_time,
                                                [&](Vertex v, core::Seconds) { return bool{goal[v]}; }, {});

    const SearchTree all =
        find_earliest_arrivals(graph, {source, std::nullopt, core::Seconds{0.0}}, travel_time, {});
    double least = SearchTree::never;
    for (Vertex v = 0; v < graph.size(); ++v)
      if (goal[v]) least = std::min(least, all.arrival_s(v));
    ASSERT_EQ(found.goal.has_value(), least <= latest.count());
    if (found.goal) {
      EXPECT_DOUBLE_EQ(found.tree.arrival_s(*found.goal), least);
    }
  });
}

TEST(NearestGoalSearch, AsksForTheGoalAtTheTimeOfArrival) {
  const GridGraph graph{10, 1, 1};
  const auto second_each = [](const Edge&, core::Seconds, core::Seconds) {
    return std::optional{core::Seconds{1.0}};
  };

  const NearestGoal found = find_nearest_goal(
      graph, 0, core::Seconds{0.0}, core::Seconds{100.0}, second_each,
      [](Vertex v, core::Seconds arrival) { return v > 2 && arrival >= core::Seconds{5.0}; }, {});

  EXPECT_EQ(found.goal, 5U);
}

}  // namespace
}  // namespace floeplan::graph::nearest_goal_search_test

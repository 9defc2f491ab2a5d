#include "engine/graph/corridors.hpp"

#include <gtest/gtest.h>

#include <set>

namespace floeplan::graph::corridors_test {
namespace {

/// One second for every step of the grid.
struct OneSecond {
  std::optional<core::Seconds> operator()(const Edge&, core::Seconds, core::Seconds) const {
    return core::Seconds{1.0};
  }
};

TEST(Corridors, StartWithTheEarliestPath) {
  const GridGraph graph{20, 11, 2};
  const Query query{graph.vertex(0, 5), graph.vertex(19, 5), core::Seconds{0.0}};

  const auto corridors = find_corridors(graph, query, OneSecond{}, 3);

  ASSERT_FALSE(corridors.empty());
  const auto tree = find_earliest_arrivals(graph, query, OneSecond{}, {});
  EXPECT_EQ(corridors.front(), path_to(graph, tree, *query.goal));
}

TEST(Corridors, LeadFromStartToGoalAndPartInTheMiddle) {
  const GridGraph graph{40, 31, 1};
  const Query query{graph.vertex(0, 15), graph.vertex(39, 15), core::Seconds{0.0}};

  const auto corridors = find_corridors(graph, query, OneSecond{}, 3);

  ASSERT_EQ(corridors.size(), 3U);
  std::set<Vertex> middles;
  for (const auto& path : corridors) {
    EXPECT_EQ(path.front(), query.source);
    EXPECT_EQ(path.back(), *query.goal);
    for (const Vertex v : path) EXPECT_FALSE(middles.contains(v));
    middles.insert(path[path.size() / 2]);
  }
}

TEST(Corridors, EndWhenNoOtherWayIsLeft) {
  const GridGraph canal{30, 1, 1};
  const Query query{canal.vertex(0, 0), canal.vertex(29, 0), core::Seconds{0.0}};

  EXPECT_EQ(find_corridors(canal, query, OneSecond{}, 5).size(), 1U);
}

}  // namespace
}  // namespace floeplan::graph::corridors_test

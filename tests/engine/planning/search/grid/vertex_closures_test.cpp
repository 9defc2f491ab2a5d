#include "engine/planning/search/grid/vertex_closures.hpp"

#include <gtest/gtest.h>

#include "tests/engine/planning/drifting_bergs.hpp"
#include "tests/engine/planning/search/bounds/foresight_waters.hpp"

namespace floeplan::planning::search::vertex_closures_test {
namespace {

TEST(VertexClosures, AreThoseOfTheSeaAtTheVertex) {
  std::size_t closed = 0;
  support::for_each_seed(5, [&](std::mt19937_64& rng) {
    ocean::Environment environment;
    for (int i = 0; i < 12; ++i) {
      const geo::LonLat place{support::uniform(rng, -53.5, -52.5), support::uniform(rng, 68.9, 69.1)};
      environment.icebergs.push_back(
          drifting_berg(place, 200.0, support::uniform(rng, 0.0, 0.3), support::uniform(rng, 0.0, 360.0)));
    }
    const Waters waters{environment};
    VertexClosures closures{waters.sea.domain().closures(), waters.grid};
    for (int i = 0; i < 50; ++i) {
      const graph::Vertex v = random_vertex(rng, waters.open);
      const std::vector<TimeSpan> expected =
          waters.sea.domain().closures().closed_times(waters.grid.point(v));
      const std::vector<TimeSpan>& first = closures.at(v);
      ASSERT_EQ(first.size(), expected.size());
      for (std::size_t span = 0; span < expected.size(); ++span) {
        EXPECT_EQ(first[span].from, expected[span].from);
        EXPECT_EQ(first[span].until, expected[span].until);
      }
      EXPECT_EQ(&closures.at(v), &first) << "what is worked out is kept";
      closed += expected.size();
    }
  });
  EXPECT_GT(closed, 0U);
}

TEST(VertexClosures, StayWhereTheyAreWhileOthersAreAsked) {
  ocean::Environment environment;
  environment.icebergs.push_back(drifting_berg({-53.0, 69.0}, 400.0, 0.1, 90.0));
  const Waters waters{environment};
  VertexClosures closures{waters.sea.domain().closures(), waters.grid};
  const std::vector<TimeSpan>& at_goal = closures.at(waters.grid.goal);
  const std::size_t count = at_goal.size();
  for (graph::Vertex v = 0; v < waters.open.graph.size(); ++v) static_cast<void>(closures.at(v));

  EXPECT_EQ(&closures.at(waters.grid.goal), &at_goal);
  EXPECT_EQ(at_goal.size(), count);
}

TEST(VertexClosures, AreNoneInASeaWhereNothingOpensAndCloses) {
  const Waters waters{{}};
  VertexClosures closures{waters.sea.domain().closures(), waters.grid};
  EXPECT_TRUE(closures.at(waters.grid.start).empty());
  EXPECT_TRUE(closures.at(waters.grid.goal).empty());
}

}  // namespace
}  // namespace floeplan::planning::search::vertex_closures_test

#include <gtest/gtest.h>

#include <optional>
#include <stop_token>
#include <vector>

#include "engine/graph/time_dependent_astar.hpp"
#include "engine/graph/tve_search.hpp"
#include "tests/engine/graph/swinging_times.hpp"
#include "tests/support/property.hpp"

namespace floeplan::graph::search_cases_test {
namespace {

/// One second for each edge, whatever its length.
std::optional<core::Seconds> one_second(const Edge&, core::Seconds, core::Seconds) {
  return core::Seconds{1.0};
}

TEST(Searches, ReachNothingFromAClosedSource) {
  const GridGraph graph{3, 1, 1, {0, 1, 1}};
  const Query query{.source = 0, .goal = {}, .depart = {}};

  EXPECT_FALSE(find_earliest_arrivals_tve(graph, query, one_second, {}).is_reached(0));
  EXPECT_FALSE(find_earliest_arrivals(graph, query, one_second, {}).is_reached(0));
}

TEST(Searches, DoNotReachAClosedGoal) {
  const GridGraph graph{3, 1, 1, {1, 1, 0}};
  const Query query{.source = 0, .goal = 2, .depart = {}};

  const SearchTree tve = find_earliest_arrivals_tve(graph, query, one_second, {});
  const SearchTree label_setting = find_earliest_arrivals(graph, query, one_second, {});

  EXPECT_FALSE(tve.is_reached(2));
  EXPECT_FALSE(label_setting.is_reached(2));
  EXPECT_TRUE(path_to(graph, tve, 2).empty());
}

TEST(LabelSettingSearch, EndsAtTheGoalAndTveDoesNot) {
  const GridGraph graph{10, 1, 1};
  const Query query{.source = 0, .goal = 3, .depart = {}};

  EXPECT_FALSE(find_earliest_arrivals(graph, query, one_second, {}).is_reached(5));
  EXPECT_TRUE(find_earliest_arrivals_tve(graph, query, one_second, {}).is_reached(9));
}

TEST(Searches, StopBeforeTheFirstExpansionWhenTheStopIsAlreadyRequested) {
  const GridGraph graph{5, 5, 1};
  std::stop_source stop;
  stop.request_stop();
  const Query query{.source = 0, .goal = {}, .depart = {}};

  const SearchTree tve = find_earliest_arrivals_tve(graph, query, one_second, stop.get_token());
  const SearchTree label_setting = find_earliest_arrivals(graph, query, one_second, stop.get_token());

  EXPECT_TRUE(tve.stopped);
  EXPECT_EQ(tve.counters.expansions, 0);
  EXPECT_TRUE(label_setting.stopped);
  EXPECT_EQ(label_setting.counters.expansions, 0);
}

TEST(Searches, StopAtTheNextLookOnceTheStopIsRequestedOnTheWay) {
  const GridGraph graph{100, 100, 1};
  const Query query{.source = 0, .goal = {}, .depart = {}};
  const auto run_to_second_look = [&](const auto& search) {
    std::stop_source stop;
    return search(stop.get_token(), [&](std::int64_t expansions) {
      if (expansions > 0) stop.request_stop();
    });
  };

  const SearchTree tve =
      run_to_second_look([&](const std::stop_token& stop, const ExpansionCallback& report) {
        return find_earliest_arrivals_tve(graph, query, one_second, stop, report);
      });
  const SearchTree label_setting =
      run_to_second_look([&](const std::stop_token& stop, const ExpansionCallback& report) {
        return find_earliest_arrivals(graph, query, one_second, stop, NoBound{}, report);
      });

  EXPECT_TRUE(tve.stopped);
  EXPECT_EQ(tve.counters.expansions, expansions_between_reports + expansions_between_looks);
  EXPECT_TRUE(label_setting.stopped);
  EXPECT_EQ(label_setting.counters.expansions, expansions_between_reports + expansions_between_looks);
}

TEST(Searches, AreNotStoppedWhenTheyRunToTheEnd) {
  const GridGraph graph{5, 5, 1};

  EXPECT_FALSE(find_earliest_arrivals_tve(graph, {}, one_second, {}).stopped);
  EXPECT_FALSE(find_earliest_arrivals(graph, {}, one_second, {}).stopped);
}

TEST(PathTo, TheSourceIsTheSourceAlone) {
  const GridGraph graph{3, 3, 1};
  const SearchTree tree =
      find_earliest_arrivals(graph, {.source = 4, .goal = {}, .depart = {}}, one_second, {});

  EXPECT_EQ(path_to(graph, tree, 4), std::vector<Vertex>{4});
}

TEST(PathTo, AVertexGoesRoundWhatIsClosed) {
  // S # G
  // . # .
  // . . .
  const GridGraph graph{3, 3, 1, {1, 0, 1, 1, 0, 1, 1, 1, 1}};
  const SearchTree tree = find_earliest_arrivals_tve(graph, {}, one_second, {});

  EXPECT_EQ(path_to(graph, tree, 2), (std::vector<Vertex>{0, 3, 7, 5, 2}));
  EXPECT_EQ(tree.arrival_s(2), 4.0);
}

TEST(PathTo, AVertexTravelledEdgeByEdgeArrivesWhenTheTreeSays) {
  support::for_each_seed(50, [](std::mt19937_64& rng) {
    const GridGraph graph = random_grid(rng);
    const SwingingTimes times{graph, rng};
    const SearchTree tree = find_earliest_arrivals(graph, {}, times, {});

    for (Vertex goal = 0; goal < graph.size(); ++goal) {
      if (!tree.is_reached(goal)) continue;
      const std::vector<Vertex> path = path_to(graph, tree, goal);
      double clock_s = 0.0;
      for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const Edge edge{path[i], path[i + 1], tree.step(path[i + 1])};
        clock_s += times(edge, core::Seconds{clock_s}, core::Seconds{SearchTree::never})->count();
      }
      ASSERT_EQ(path.front(), 0U);
      ASSERT_EQ(path.back(), goal);
      ASSERT_DOUBLE_EQ(clock_s, tree.arrival_s(goal));
    }
  });
}

}  // namespace
}  // namespace floeplan::graph::search_cases_test

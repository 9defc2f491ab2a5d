#include <gtest/gtest.h>

#include <optional>
#include <stop_token>

#include "engine/graph/time_dependent_astar.hpp"
#include "engine/graph/tve_search.hpp"

namespace floeplan::graph::broken_laws_test {
namespace {

constexpr Vertex source = 0;
constexpr Vertex crossing = 2;
constexpr Vertex goal = 3;

/// 0 1 2 3    Two ways lead from 0 to the crossing 2: over 1 and over 5. Only the crossing leads to the goal.
/// # 5 # #
GridGraph crossing_grid() { return GridGraph{4, 2, 1, {1, 1, 1, 1, 0, 1, 0, 0}}; }

TEST(Searches, WithoutFifoTakeTheEarlyArrivalThatHasToWaitLonger) {
  // The last edge takes 100 s for a departure before t = 10 s, and 1 s afterwards. The slower route would
  // arrive at 13 s, but both searches keep only the earliest arrival at the crossing.
  const auto opens_at_ten = [](const Edge& edge, core::Seconds depart,
                               core::Seconds) -> std::optional<core::Seconds> {
    if (edge.head < edge.tail && edge.tail != 5) return std::nullopt;
    if (edge.head == goal) return core::Seconds{depart.count() < 10.0 ? 100.0 : 1.0};
    return core::Seconds{edge.tail == 1 || edge.head == 1 ? 6.0 : 2.0};
  };
  const GridGraph graph = crossing_grid();
  const Query query{.source = source, .goal = {}, .depart = {}};

  const SearchTree tve = find_earliest_arrivals_tve(graph, query, opens_at_ten, {});
  const SearchTree label_setting = find_earliest_arrivals(graph, query, opens_at_ten, {});

  EXPECT_EQ(tve.arrival_s(crossing), 4.0);
  EXPECT_EQ(tve.arrival_s(goal), 104.0);
  EXPECT_EQ(label_setting.arrival_s(goal), 104.0);
  EXPECT_EQ(tve.counters.reinsertions, 0);
}

TEST(TveSearch, CorrectsAnExpandedVertexThatATimeBelowZeroReachesEarlierAndCountsIt) {
  // Vertex 2 is expanded at 4 s on the path over 5; the path over 1 reaches it at 6 - 5 = 1 s.
  const auto back_in_time = [](const Edge& edge, core::Seconds,
                               core::Seconds) -> std::optional<core::Seconds> {
    if (edge.head < edge.tail && edge.tail != 5) return std::nullopt;
    if (edge.tail == 1 && edge.head == 5) return std::nullopt;
    if (edge.tail == 5 && edge.head == 1) return std::nullopt;
    if (edge.tail == 1 && edge.head == 2) return core::Seconds{-5.0};
    return core::Seconds{edge.head == 1 ? 6.0 : 2.0};
  };
  const GridGraph graph = crossing_grid();
  const Query query{.source = source, .goal = {}, .depart = {}};

  const SearchTree tve = find_earliest_arrivals_tve(graph, query, back_in_time, {});
  const SearchTree label_setting = find_earliest_arrivals(graph, query, back_in_time, {});

  EXPECT_EQ(tve.arrival_s(goal), 3.0);
  EXPECT_GT(tve.counters.reinsertions, 0);
  EXPECT_EQ(label_setting.arrival_s(goal), 6.0);
}

}  // namespace
}  // namespace floeplan::graph::broken_laws_test

#include <gtest/gtest.h>

#include <stop_token>
#include <vector>

#include "engine/graph/time_dependent_astar.hpp"
#include "engine/graph/tve_search.hpp"
#include "tests/engine/graph/swinging_times.hpp"
#include "tests/support/property.hpp"

namespace floeplan::graph::search_laws_test {
namespace {

constexpr double rounding_s = 1e-9;  // sums of the same times in the same order

/// Relaxes every edge again and again until nothing changes (Bellman and Ford).
std::vector<double> arrivals_by_brute_force(const GridGraph& graph, const Query& query,
                                            const SwingingTimes& times) {
  std::vector<double> arrival_s(graph.size(), SearchTree::never);
  arrival_s[query.source] = query.depart.count();
  for (bool changed = true; changed;) {
    changed = false;
    for (Vertex tail = 0; tail < graph.size(); ++tail) {
      if (!graph.is_open(tail) || arrival_s[tail] == SearchTree::never) continue;
      graph.for_each_edge(tail, [&](const Edge& edge) {
        const auto duration = times(edge, core::Seconds{arrival_s[tail]}, core::Seconds{SearchTree::never});
        if (!duration || arrival_s[tail] + duration->count() >= arrival_s[edge.head]) return;
        arrival_s[edge.head] = arrival_s[tail] + duration->count();
        changed = true;
      });
    }
  }
  return arrival_s;
}

void expect_certificates(const GridGraph& graph, const Query& query, const SearchTree& tree,
                         const SwingingTimes& times) {
  std::vector<bool> tight(graph.size(), false);
  for (Vertex tail = 0; tail < graph.size(); ++tail) {
    if (!tree.is_reached(tail)) continue;
    graph.for_each_edge(tail, [&](const Edge& edge) {
      const double depart_s = tree.arrival_s(tail);
      const auto duration = times(edge, core::Seconds{depart_s}, core::Seconds{SearchTree::never});
      if (!duration) return;
      EXPECT_GE(depart_s + duration->count(), tree.arrival_s(edge.head) - rounding_s) << "still relaxes";
      if (tree.has_predecessor(edge.head) && tree.step(edge.head) == edge.step) {
        tight[edge.head] = depart_s + duration->count() == tree.arrival_s(edge.head);
      }
    });
  }
  for (Vertex v = 0; v < graph.size(); ++v) {
    EXPECT_EQ(tree.is_reached(v), tight[v] || v == query.source) << "vertex " << v;
  }
}

TEST(Searches, FindTheArrivalsOfBruteForceUnderFifo) {
  support::for_each_seed(60, [](std::mt19937_64& rng) {
    const GridGraph graph = random_grid(rng);
    const SwingingTimes times{graph, rng};
    const Query query{.source = 0, .goal = {}, .depart = core::Seconds{support::uniform(rng, 0.0, 1e4)}};

    const SearchTree tve = find_earliest_arrivals_tve(graph, query, times, {});
    const SearchTree label_setting = find_earliest_arrivals(graph, query, times, {});

    const std::vector<double> expected_s = arrivals_by_brute_force(graph, query, times);
    for (Vertex v = 0; v < graph.size(); ++v) {
      ASSERT_EQ(tve.is_reached(v), expected_s[v] < SearchTree::never);
      ASSERT_EQ(label_setting.is_reached(v), tve.is_reached(v));
      if (!tve.is_reached(v)) continue;
      EXPECT_NEAR(tve.arrival_s(v), expected_s[v], rounding_s);
      EXPECT_NEAR(label_setting.arrival_s(v), expected_s[v], rounding_s);
    }
  });
}

TEST(Searches, LeaveNoEdgeToRelaxAndGiveEveryVertexATightPredecessor) {
  support::for_each_seed(60, [](std::mt19937_64& rng) {
    const GridGraph graph = random_grid(rng);
    const SwingingTimes times{graph, rng};
    const Query query{.source = 0, .goal = {}, .depart = core::Seconds{support::uniform(rng, 0.0, 1e4)}};

    expect_certificates(graph, query, find_earliest_arrivals_tve(graph, query, times, {}), times);
    expect_certificates(graph, query, find_earliest_arrivals(graph, query, times, {}), times);
  });
}

TEST(TveSearch, ExpandsEveryVertexOnceUnderFifoAndEvaluatesEachOfItsEdges) {
  support::for_each_seed(30, [](std::mt19937_64& rng) {
    const GridGraph graph = random_grid(rng);
    const SwingingTimes times{graph, rng};

    const SearchTree tree =
        find_earliest_arrivals_tve(graph, {.source = 0, .goal = {}, .depart = {}}, times, {});

    std::int64_t reached = 0;
    std::int64_t edges = 0;
    for (Vertex v = 0; v < graph.size(); ++v) {
      if (!tree.is_reached(v)) continue;
      ++reached;
      graph.for_each_edge(v, [&](const Edge&) { ++edges; });
    }
    EXPECT_EQ(tree.counters.expansions, reached);
    EXPECT_EQ(tree.counters.edge_evaluations, edges);
    EXPECT_EQ(tree.counters.reinsertions, 0);
  });
}

/// The straight line to the goal at the least pace of all.
struct StraightLineBound {
  const GridGraph& graph;
  Vertex goal;

  [[nodiscard]] core::Seconds least_time(const Edge& edge, core::Seconds) const {
    return core::Seconds{SwingingTimes::least_pace_s * SwingingTimes::cells(graph.offsets()[edge.step])};
  }
  [[nodiscard]] core::Seconds remaining(Vertex v) const {
    const Offset to_goal{graph.column(goal) - graph.column(v), graph.row(goal) - graph.row(v)};
    return core::Seconds{SwingingTimes::least_pace_s * SwingingTimes::cells(to_goal)};
  }
  [[nodiscard]] static core::Seconds latest_use(Vertex) { return core::Seconds{SearchTree::never}; }
};

TEST(LabelSettingSearch, WithABoundFindsTheSameArrivalWithNoMoreExpansions) {
  support::for_each_seed(100, [](std::mt19937_64& rng) {
    const GridGraph graph = random_grid(rng);
    const SwingingTimes times{graph, rng};
    const auto goal = static_cast<Vertex>(support::uniform_int(rng, 0, static_cast<int>(graph.size()) - 1));
    const Query query{.source = 0, .goal = goal, .depart = core::Seconds{support::uniform(rng, 0.0, 1e4)}};

    const SearchTree plain = find_earliest_arrivals(graph, query, times, {});
    const SearchTree bounded =
        find_earliest_arrivals(graph, query, times, {}, StraightLineBound{graph, goal});

    ASSERT_EQ(bounded.is_reached(goal), plain.is_reached(goal));
    if (plain.is_reached(goal)) {
      EXPECT_NEAR(bounded.arrival_s(goal), plain.arrival_s(goal), rounding_s);
    }
    EXPECT_LE(bounded.counters.expansions, plain.counters.expansions);
    EXPECT_LE(bounded.counters.edge_evaluations, plain.counters.edge_evaluations);
  });
}

}  // namespace
}  // namespace floeplan::graph::search_laws_test

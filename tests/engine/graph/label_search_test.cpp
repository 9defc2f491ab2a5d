#include "engine/graph/label_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "engine/graph/time_dependent_astar.hpp"
#include "tests/engine/graph/swinging_times.hpp"
#include "tests/support/property.hpp"

namespace floeplan::graph::label_search_test {
namespace {

constexpr std::size_t plenty = 1'000'000;
constexpr double never = std::numeric_limits<double>::infinity();

/// A world with times in whole hours. For each hour of departure an edge is closed, or takes 1 to 3 hours at
/// random, so a later departure may arrive earlier. A fast vehicle takes 1 hour and more energy.
class HourlyWorld {
 public:
  struct State {
    double energy{};
  };
  enum Choice : std::uint32_t { slow, fast, stay };
  static constexpr int hours = 9;

  HourlyWorld(const GridGraph& graph, Vertex goal, bool may_wait, bool for_energy, std::mt19937_64& rng)
      : steps_{graph.offsets().size()}, goal_{goal}, may_wait_{may_wait}, for_energy_{for_energy} {
    durations_.resize(graph.size() * steps_ * hours);
    for (int& duration : durations_) duration = std::max(0, support::uniform_int(rng, -2, 3));
  }

  void extend(const Edge& edge, double arrival_s, const State& state, auto&& emit) const {
    if (arrival_s >= hours) return;
    const int duration =
        durations_[(edge.tail * steps_ + edge.step) * hours + static_cast<std::size_t>(arrival_s)];
    if (duration == 0) return;
    emit(arrival_s + duration, State{state.energy + 1.0}, slow);
    if (duration > 1) emit(arrival_s + 1.0, State{state.energy + 4.0}, fast);
  }
  void wait(Vertex, double arrival_s, const State& state, auto&& emit) const {
    if (may_wait_ && arrival_s + 1.0 < hours) emit(arrival_s + 1.0, State{state.energy + 0.5}, stay);
  }
  [[nodiscard]] double key(Vertex, double arrival_s, const State& state) const {
    return for_energy_ ? state.energy : arrival_s;
  }
  /// Arrivals at different hours cannot be compared.
  [[nodiscard]] static bool dominates(Vertex, const Label<State>& a, const Label<State>& b) {
    return a.arrival_s == b.arrival_s && a.state.energy <= b.state.energy;
  }

  /// Least key of all paths to the goal, found by trying all of them.
  [[nodiscard]] double best_by_enumeration(const GridGraph& graph, Vertex v, double arrival_s,
                                           const State& state) const {
    if (v == goal_) return key(v, arrival_s, state);
    double best = never;
    graph.for_each_edge(v, [&](const Edge& edge) {
      extend(edge, arrival_s, state, [&](double arrival, const State& then, std::uint32_t) {
        best = std::min(best, best_by_enumeration(graph, edge.head, arrival, then));
      });
    });
    wait(v, arrival_s, state, [&](double arrival, const State& then, std::uint32_t) {
      best = std::min(best, best_by_enumeration(graph, v, arrival, then));
    });
    return best;
  }

 private:
  std::size_t steps_;
  Vertex goal_;
  bool may_wait_;
  bool for_energy_;
  std::vector<int> durations_;  // [edge][hour of departure]; 0: closed
};

TEST(LabelSearch, FindsTheBestOfAllWaysWhereLeavingLaterMayArriveEarlier) {
  int found = 0;
  support::for_each_seed(400, [&](std::mt19937_64& rng) {
    const GridGraph graph{3, 2, 1};
    const auto goal = static_cast<Vertex>(support::uniform_int(rng, 1, 5));
    const bool may_wait = support::uniform_int(rng, 0, 1) == 1;
    const bool for_energy = support::uniform_int(rng, 0, 1) == 1;
    const HourlyWorld world{graph, goal, may_wait, for_energy, rng};
    const double depart_s = support::uniform_int(rng, 3, 5);

    const auto search = find_best_labels(graph, 0, goal, depart_s, {}, world, plenty, {});

    const double best = world.best_by_enumeration(graph, 0, depart_s, {});
    ASSERT_EQ(search.goal.has_value(), best < never);
    if (!search.goal) return;
    ++found;
    const auto& end = search.labels[*search.goal];
    EXPECT_EQ(world.key(goal, end.arrival_s, end.state), best);

    const double slack = support::uniform(rng, 0.0, 0.5 * best);
    const auto rough = find_best_labels(graph, 0, goal, depart_s, {}, world, plenty, {}, {}, slack);
    ASSERT_TRUE(rough.goal);
    const auto& rough_end = rough.labels[*rough.goal];
    EXPECT_LE(world.key(goal, rough_end.arrival_s, rough_end.state), best + slack);
    EXPECT_LE(rough.counters.expansions, search.counters.expansions);
  });
  EXPECT_GT(found, 200);
}

TEST(LabelSearch, ReturnsAWayThatTheModelAllowsStepByStep) {
  support::for_each_seed(100, [](std::mt19937_64& rng) {
    const GridGraph graph{4, 4, 2};
    const HourlyWorld world{graph, 15, support::uniform_int(rng, 0, 1) == 1, true, rng};

    const auto search = find_best_labels(graph, 0, 15, 0.0, {}, world, plenty, {});

    if (!search.goal) return;
    const auto way = way_to(search, *search.goal);
    EXPECT_EQ(way.front().vertex, 0U);
    EXPECT_EQ(way.front().arrival_s, 0.0);
    EXPECT_EQ(way.back().vertex, 15U);
    for (std::size_t i = 1; i < way.size(); ++i) {
      bool allowed = false;
      const auto same = [&](double arrival_s, const HourlyWorld::State& state, std::uint32_t choice) {
        allowed |=
            arrival_s == way[i].arrival_s && state.energy == way[i].state.energy && choice == way[i].choice;
      };
      if (way[i].vertex == way[i - 1].vertex) {
        world.wait(way[i].vertex, way[i - 1].arrival_s, way[i - 1].state, same);
      } else {
        graph.for_each_edge(way[i - 1].vertex, [&](const Edge& edge) {
          if (edge.head == way[i].vertex) world.extend(edge, way[i - 1].arrival_s, way[i - 1].state, same);
        });
      }
      EXPECT_TRUE(allowed) << "step " << i;
    }
  });
}

/// Only arrival times, as in the plain search.
struct PlainVoyage {
  struct State {};
  const SwingingTimes& times;

  void extend(const Edge& edge, double arrival_s, const State&, auto&& emit) const {
    if (const auto time = times(edge, core::Seconds{arrival_s}, core::Seconds{never})) {
      emit(arrival_s + time->count(), State{}, 0U);
    }
  }
  void wait(Vertex, double, const State&, auto&&) const {}
  [[nodiscard]] static double key(Vertex, double arrival_s, const State&) { return arrival_s; }
  [[nodiscard]] static bool dominates(Vertex, const Label<State>& a, const Label<State>& b) {
    return a.arrival_s <= b.arrival_s;
  }
};

TEST(LabelSearch, AgreesWithThePlainSearchWhereOnlyTheArrivalCounts) {
  support::for_each_seed(60, [](std::mt19937_64& rng) {
    const GridGraph graph = random_grid(rng);
    const SwingingTimes times{graph, rng};
    const auto goal = static_cast<Vertex>(graph.size() - 1);
    const PlainVoyage voyage{times};

    const auto search = find_best_labels(graph, 0, goal, 50.0, {}, voyage, plenty, {});

    const SearchTree tree =
        find_earliest_arrivals(graph, {.source = 0, .goal = goal, .depart = core::Seconds{50.0}}, times, {});
    ASSERT_EQ(search.goal.has_value(), tree.is_reached(goal));
    if (search.goal) {
      EXPECT_DOUBLE_EQ(search.labels[*search.goal].arrival_s, tree.arrival_s(goal));
    }
  });
}

TEST(LabelSearch, StopsAtTheBoundOnLabelsAndSaysSo) {
  std::mt19937_64 rng{1};
  const GridGraph graph{30, 30, 1};
  const SwingingTimes times{graph, rng};
  const PlainVoyage voyage{times};

  const auto search = find_best_labels(graph, 0, 899, 0.0, {}, voyage, 100, {});

  EXPECT_TRUE(search.full);
  EXPECT_FALSE(search.goal);
  EXPECT_EQ(search.labels.size(), 100U);
}

TEST(LabelSearch, KnowsWhatNoWayThatItDidNotFindCostsLessThan) {
  int more_than_nothing = 0;
  support::for_each_seed(60, [&](std::mt19937_64& rng) {
    const GridGraph graph = random_grid(rng);
    const SwingingTimes times{graph, rng};
    const auto goal = static_cast<Vertex>(graph.size() - 1);
    const PlainVoyage voyage{times};
    const auto whole = find_best_labels(graph, 0, goal, 50.0, {}, voyage, plenty, {});
    if (!whole.goal) return;

    const auto part = find_best_labels(graph, 0, goal, 50.0, {}, voyage, whole.labels.size() / 2, {});

    EXPECT_LE(part.least_key, whole.labels[*whole.goal].arrival_s);
    more_than_nothing += part.least_key > 51.0 ? 1 : 0;
  });
  EXPECT_GT(more_than_nothing, 30);
}

TEST(LabelSearch, ReturnsTheBestWaySoFarAtTheBoundOnLabels) {
  int before_the_end = 0;
  support::for_each_seed(60, [&](std::mt19937_64& rng) {
    const GridGraph graph = random_grid(rng);
    const SwingingTimes times{graph, rng};
    const auto goal = static_cast<Vertex>(graph.size() - 1);
    const PlainVoyage voyage{times};
    const auto whole = find_best_labels(graph, 0, goal, 50.0, {}, voyage, plenty, {});

    const auto part = find_best_labels(graph, 0, goal, 50.0, {}, voyage, whole.labels.size() - 1, {});
    if (!part.goal) return;
    before_the_end += part.full ? 1 : 0;
    EXPECT_EQ(part.labels[*part.goal].vertex, goal);
    EXPECT_GE(part.labels[*part.goal].arrival_s, whole.labels[*whole.goal].arrival_s);
  });
  EXPECT_GT(before_the_end, 0);
}

TEST(LabelSearch, StopsWhenAskedTo) {
  std::mt19937_64 rng{1};
  const GridGraph graph{30, 30, 1};
  const SwingingTimes times{graph, rng};
  const PlainVoyage voyage{times};
  std::stop_source stop;
  stop.request_stop();

  const auto search = find_best_labels(graph, 0, 899, 0.0, {}, voyage, plenty, stop.get_token());

  EXPECT_TRUE(search.stopped);
  EXPECT_FALSE(search.goal);
  EXPECT_EQ(search.counters.expansions, 0);
}

TEST(LabelSearch, FindsNoWayFromAClosedVertex) {
  std::mt19937_64 rng{1};
  const GridGraph graph{2, 1, 1, {0, 1}};
  const SwingingTimes times{graph, rng};
  const PlainVoyage voyage{times};

  EXPECT_FALSE(find_best_labels(graph, 0, 1, 0.0, {}, voyage, plenty, {}).goal);
}

}  // namespace
}  // namespace floeplan::graph::label_search_test

#include "engine/graph/interval_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/property.hpp"

namespace floeplan::graph::interval_search_test {
namespace {

constexpr double never = SearchTree::never;
constexpr double horizon_s = 4000.0;
constexpr double step_s = 1.0;  // between the departures that the test world tries

struct Span {
  double from_s;
  double until_s;
};

/// Places that are safe at times, some of them to stay at and others only to pass, and edges that open and
/// close. The time of every edge oscillates slowly enough that a later departure arrives later.
class ChangingWorld {
 public:
  ChangingWorld(const GridGraph& graph, Vertex goal, double share_to_pass, std::mt19937_64& rng)
      : graph_{graph}, goal_{goal}, edges_(graph.size() * graph.offsets().size()) {
    for (Vertex v = 0; v < graph.size(); ++v) {
      intervals_.emplace_back();
      for (const Span& span : random_spans(rng, 1500.0, 400.0))
        add_parts(intervals_.back(), span, share_to_pass, rng);
    }
    for (EdgeTimes& edge : edges_) {
      edge.mean_s = support::uniform(rng, 60.0, 200.0);
      edge.rate_per_s = support::uniform(rng, 0.0, 0.95) / (0.5 * edge.mean_s);
      edge.phase = support::uniform(rng, 0.0, 6.28);
      edge.open = random_spans(rng, 500.0, 500.0);
    }
  }

  [[nodiscard]] std::vector<SafeInterval> safe_intervals(Vertex v) const { return intervals_[v]; }
  [[nodiscard]] static double least_time_s(const Edge&) { return 30.0; }
  [[nodiscard]] double remaining_s(Vertex v) const {
    const int columns = std::abs(graph_.column(v) - graph_.column(goal_));
    const int rows = std::abs(graph_.row(v) - graph_.row(goal_));
    return 30.0 * std::max(columns, rows);
  }

  /// One call tries this many departures; the search calls it again for more.
  [[nodiscard]] DepartureLook first_open(const Edge& edge, double from_s, double until_s,
                                         double arrive_from_s) const {
    constexpr int most_looks = 200;
    double depart_s = from_s;
    for (int i = 0; i < most_looks && depart_s <= until_s; ++i, depart_s += step_s) {
      const auto arrive_s = arrival_s(edge, depart_s);
      if (arrive_s && *arrive_s >= arrive_from_s) return {OpenDeparture{depart_s, *arrive_s}, depart_s};
    }
    return {std::nullopt, depart_s};
  }
  [[nodiscard]] OpenDeparture open_until(const Edge& edge, const OpenDeparture& open, double until_s,
                                         double arrive_until_s) const {
    constexpr int most_looks = 100;
    OpenDeparture last = open;
    for (int i = 0; i < most_looks; ++i) {
      const double depart_s = std::min(last.depart_s + step_s, until_s);
      const auto arrive_s = depart_s > last.depart_s ? arrival_s(edge, depart_s) : std::nullopt;
      if (!arrive_s || *arrive_s > arrive_until_s) break;
      last = {depart_s, *arrive_s};
    }
    return last;
  }

  /// Arrival of a departure; empty if the edge is closed at the departure or its head at the arrival.
  [[nodiscard]] std::optional<double> arrival_s(const Edge& edge, double depart_s) const {
    const EdgeTimes& times = edges_[edge.tail * graph_.offsets().size() + edge.step];
    const auto is_in = [](double time_s) {
      return [=](const auto& span) { return span.from_s <= time_s && time_s <= span.until_s; };
    };
    if (!std::ranges::any_of(times.open, is_in(depart_s))) return std::nullopt;
    const double swing = 0.5 * std::sin(times.rate_per_s * depart_s + times.phase);
    const double arrive_s = depart_s + times.mean_s * (1.0 + swing);
    if (!std::ranges::any_of(intervals_[edge.head], is_in(arrive_s))) return std::nullopt;
    return arrive_s;
  }
  [[nodiscard]] const SafeInterval* interval_at(Vertex v, double time_s) const {
    const auto found = std::ranges::find_if(intervals_[v], [=](const SafeInterval& safe) {
      return safe.from_s <= time_s && time_s <= safe.until_s;
    });
    return found == intervals_[v].end() ? nullptr : &*found;
  }

 private:
  struct EdgeTimes {
    double mean_s{};
    double rate_per_s{};
    double phase{};
    std::vector<Span> open;
  };

  static std::vector<Span> random_spans(std::mt19937_64& rng, double longest_s, double longest_gap_s) {
    std::vector<Span> spans;
    double now_s = support::uniform(rng, -longest_gap_s, longest_gap_s);
    while (now_s < horizon_s) {
      const double until_s = now_s + support::uniform(rng, 60.0, longest_s);
      spans.push_back({std::max(0.0, now_s), std::min(horizon_s, until_s)});
      now_s = until_s + support::uniform(rng, 60.0, longest_gap_s);
    }
    std::erase_if(spans, [](const Span& span) { return span.until_s <= span.from_s; });
    return spans;
  }
  static void add_parts(std::vector<SafeInterval>& intervals, const Span& span, double share_to_pass,
                        std::mt19937_64& rng) {
    for (double from_s = span.from_s; from_s < span.until_s;) {
      const double until_s = std::min(span.until_s, from_s + support::uniform(rng, 100.0, 800.0));
      const bool may_stay = support::uniform(rng, 0.0, 1.0) >= share_to_pass;
      if (from_s > span.from_s && intervals.back().may_stay == may_stay) {
        intervals.back().until_s = until_s;
      } else {
        intervals.push_back({from_s, until_s, may_stay});
      }
      from_s = until_s;
    }
  }

  const GridGraph& graph_;
  Vertex goal_;
  std::vector<EdgeTimes> edges_;
  std::vector<std::vector<SafeInterval>> intervals_;
};

/// The earliest arrival, found by trying all possibilities. At each vertex and in each span of four seconds,
/// only the earliest arrival is continued, and a vehicle that stays until the next span.
double by_brute_force(const GridGraph& graph, const ChangingWorld& world, Vertex source, Vertex goal) {
  constexpr double bin_s = 4.0;
  const auto bins = static_cast<std::size_t>(horizon_s / bin_s) + 1;
  std::vector<std::vector<double>> earliest(bins, std::vector<double>(graph.size(), never));
  if (world.interval_at(source, 0.0) != nullptr) earliest[0][source] = 0.0;
  for (std::size_t bin = 0; bin < bins; ++bin) {
    if (earliest[bin][goal] < never) return earliest[bin][goal];
    for (Vertex v = 0; v < graph.size(); ++v) {
      const double now_s = earliest[bin][v];
      if (now_s == never) continue;
      const auto reach = [&](Vertex there, double time_s) {
        const auto then = static_cast<std::size_t>(time_s / bin_s);
        if (then < bins) earliest[then][there] = std::min(earliest[then][there], time_s);
      };
      graph.for_each_edge(v, [&](const Edge& edge) {
        if (const auto arrive_s = world.arrival_s(edge, now_s)) reach(edge.head, *arrive_s);
      });
      const double next_s = bin_s * static_cast<double>(bin + 1);
      const SafeInterval* here = world.interval_at(v, next_s);
      const SafeInterval* before = world.interval_at(v, now_s);
      if (here != nullptr && here == before && here->may_stay) reach(v, next_s);
    }
  }
  return never;
}

/// Expects that a vehicle can travel this path, within a step of the test world.
void expect_can_be_gone(const ChangingWorld& world, const GridGraph& graph, const std::vector<Visit>& way) {
  double now_s = way.front().arrive_s;
  for (std::size_t i = 0; i + 1 < way.size(); ++i) {
    const Visit& here = way[i];
    EXPECT_NEAR(now_s, here.arrive_s, 3.0 * step_s);
    if (here.leave_s > here.arrive_s + 3.0 * step_s) {
      const SafeInterval* safe = world.interval_at(here.vertex, 0.5 * (here.arrive_s + here.leave_s));
      ASSERT_NE(safe, nullptr);
      EXPECT_TRUE(safe->may_stay);
      EXPECT_LE(safe->from_s, here.arrive_s);
      EXPECT_GE(safe->until_s, here.leave_s);
    }
    std::optional<double> arrive_s;
    graph.for_each_edge(here.vertex, [&](const Edge& edge) {
      if (edge.head == way[i + 1].vertex) arrive_s = world.arrival_s(edge, here.leave_s);
    });
    ASSERT_TRUE(arrive_s) << "closed from " << here.vertex << " at " << here.leave_s;
    now_s = *arrive_s;
  }
}

class AmongIntervals : public testing::TestWithParam<double> {};

TEST_P(AmongIntervals, NoArrivalOfBruteForceIsEarlier) {
  int found = 0;
  support::for_each_seed(400, [&](std::mt19937_64& rng) {
    const GridGraph graph{5, 4, 1};
    const Vertex goal = static_cast<Vertex>(graph.size()) - 1;
    ChangingWorld world{graph, goal, GetParam(), rng};
    const double expected_s = by_brute_force(graph, world, 0, goal);

    const IntervalSearch search = find_earliest_among_intervals(graph, {0, goal, {}}, world, {}, {});

    EXPECT_FALSE(search.stopped || search.full);
    if (!search.way.empty()) expect_can_be_gone(world, graph, search.way);
    if (expected_s == never) return;  // the brute force may miss departures between those that it tries
    ++found;
    ASSERT_FALSE(search.way.empty()) << expected_s;
    EXPECT_LE(search.arrival_s(), expected_s + 60.0);
  });
  EXPECT_GT(found, 20);
}

INSTANTIATE_TEST_SUITE_P(ShareOnlyToPass, AmongIntervals, testing::Values(0.0, 0.5, 0.9));

/// An edge that opens at 1000 s. The vehicle may stay at its tail, or only at the vertex before that.
class Gate {
 public:
  static constexpr double opens_s = 1000.0;
  explicit Gate(bool may_stay_before_it) : may_stay_{may_stay_before_it} {}

  [[nodiscard]] std::vector<SafeInterval> safe_intervals(Vertex v) const {
    return {{0.0, 5000.0, v == 1 ? may_stay_ : true}};
  }
  [[nodiscard]] static DepartureLook first_open(const Edge& edge, double from_s, double until_s,
                                                double arrive_from_s) {
    double depart_s = std::max(from_s, arrive_from_s - time_s);
    if (edge.tail == 1 && edge.head == 2) depart_s = std::max(depart_s, opens_s);
    if (depart_s > until_s) return {std::nullopt, never};
    return {OpenDeparture{depart_s, depart_s + time_s}, depart_s};
  }
  [[nodiscard]] static OpenDeparture open_until(const Edge&, const OpenDeparture&, double until_s,
                                                double arrive_until_s) {
    const double depart_s = std::min(until_s, arrive_until_s - time_s);
    return {depart_s, depart_s + time_s};
  }
  [[nodiscard]] static double least_time_s(const Edge&) { return time_s; }
  [[nodiscard]] static double remaining_s(Vertex v) { return v < 2 ? time_s * (2.0 - v) : 0.0; }

  static constexpr double time_s = 100.0;

 private:
  bool may_stay_;
};

TEST(AmongIntervals, TheVehicleStaysAsNearToWhatOpensAsItMay) {
  const GridGraph graph{3, 1, 1};
  Gate near{true};
  Gate far{false};

  const IntervalSearch at_the_gate = find_earliest_among_intervals(graph, {0, 2, {}}, near, {}, {});
  const IntervalSearch before_it = find_earliest_among_intervals(graph, {0, 2, {}}, far, {}, {});

  ASSERT_EQ(at_the_gate.way.size(), 3U);
  EXPECT_EQ(at_the_gate.way[0].leave_s, 0.0);
  EXPECT_EQ(at_the_gate.way[1].leave_s, Gate::opens_s);
  ASSERT_EQ(before_it.way.size(), 3U);
  EXPECT_EQ(before_it.way[0].leave_s, Gate::opens_s - Gate::time_s);
  EXPECT_EQ(before_it.arrival_s(), Gate::opens_s + Gate::time_s);
}

TEST(AmongIntervals, AnArrivalAfterTheLatestIsNone) {
  const GridGraph graph{3, 1, 1};
  Gate gate{true};
  const core::Seconds arrival{Gate::opens_s + Gate::time_s};
  const Query in_time{0, 2, {}, arrival};
  const Query too_early{0, 2, {}, arrival - core::Seconds{1.0}};

  EXPECT_FALSE(find_earliest_among_intervals(graph, in_time, gate, {}, {}).way.empty());
  EXPECT_TRUE(find_earliest_among_intervals(graph, too_early, gate, {}, {}).way.empty());
}

TEST(AmongIntervals, ASearchEndsWhenItIsStoppedOrMeetsABound) {
  const GridGraph graph{3, 1, 1};
  Gate gate{true};
  std::stop_source stop;
  stop.request_stop();

  const IntervalSearch stopped = find_earliest_among_intervals(graph, {0, 2, {}}, gate, {}, stop.get_token());
  const IntervalSearch of_memory =
      find_earliest_among_intervals(graph, {0, 2, {}}, gate, {.most_entries = 2}, {});
  const IntervalSearch of_work =
      find_earliest_among_intervals(graph, {0, 2, {}}, gate, {.most_looks = 0}, {});

  EXPECT_TRUE(stopped.stopped);
  EXPECT_TRUE(stopped.way.empty());
  for (const IntervalSearch& full : {of_memory, of_work}) {
    EXPECT_TRUE(full.full);
    EXPECT_TRUE(full.way.empty());
    EXPECT_LE(full.none_before_s, Gate::opens_s + Gate::time_s);
  }
}

}  // namespace
}  // namespace floeplan::graph::interval_search_test

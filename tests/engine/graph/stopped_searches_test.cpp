#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <stop_token>

#include "engine/graph/label_search.hpp"
#include "engine/graph/nearest_goal_search.hpp"
#include "engine/graph/time_dependent_astar.hpp"
#include "engine/graph/tve_search.hpp"
#include "tests/support/property.hpp"

/// After a requested stop a search times only a few more edges, at any moment. This number times the longest
/// time for an edge is the longest wait of a caller.
namespace floeplan::graph::stopped_searches_test {
namespace {

/// Requests the stop when a given number of edges has been timed, and counts the edges after it.
class StoppingTimes {
 public:
  explicit StoppingTimes(std::int64_t edges_before) : left_{edges_before} {}

  [[nodiscard]] core::Seconds time() {
    if (left_-- == 0) source_.request_stop();
    if (left_ < 0) ++after_;
    return core::Seconds{1.0};
  }
  [[nodiscard]] std::stop_token token() const { return source_.get_token(); }
  [[nodiscard]] std::int64_t after() const { return after_; }

 private:
  std::stop_source source_;
  std::int64_t left_;
  std::int64_t after_{0};
};

struct StoppingVoyage {
  struct State {};
  StoppingTimes& times;

  void extend(const Edge&, double arrival_s, const State&, auto&& emit) const {
    emit(arrival_s + times.time().count(), State{}, 0U);
  }
  void wait(Vertex, double, const State&, auto&&) const {}
  [[nodiscard]] double key(Vertex, double arrival_s, const State&) const { return arrival_s; }
  [[nodiscard]] bool dominates(Vertex, const Label<State>& a, const Label<State>& b) const {
    return a.arrival_s <= b.arrival_s;
  }
};

const GridGraph graph{120, 120, 3};
constexpr Vertex last = 120 * 120 - 1;

using Search = std::function<bool(StoppingTimes& times)>;  // whether it says that it was stopped

void expect_few_edges_after_a_stop(const Search& search, std::int64_t expansions_between_looks_of_it) {
  support::for_each_seed(20, [&](std::mt19937_64& rng) {
    StoppingTimes times{support::uniform_int(rng, 0, 60'000)};

    EXPECT_TRUE(search(times));

    const auto edges = static_cast<std::int64_t>(graph.offsets().size());
    EXPECT_GT(times.after(), 0);
    EXPECT_LE(times.after(), expansions_between_looks_of_it * edges);
  });
}

TEST(StoppedSearches, LabelCorrectingTimesFewEdgesMore) {
  expect_few_edges_after_a_stop(
      [](StoppingTimes& times) {
        const auto time = [&](const Edge&, core::Seconds, core::Seconds) {
          return std::optional{times.time()};
        };
        return find_earliest_arrivals_tve(graph, {.source = 0, .goal = last, .depart = {}}, time,
                                          times.token())
            .stopped;
      },
      expansions_between_looks);
}

TEST(StoppedSearches, LabelSettingTimesFewEdgesMore) {
  expect_few_edges_after_a_stop(
      [](StoppingTimes& times) {
        const auto time = [&](const Edge&, core::Seconds, core::Seconds) {
          return std::optional{times.time()};
        };
        return find_earliest_arrivals(graph, {.source = 0, .goal = last, .depart = {}}, time, times.token())
            .stopped;
      },
      expansions_between_looks);
}

TEST(StoppedSearches, NearestGoalTimesFewEdgesMore) {
  expect_few_edges_after_a_stop(
      [](StoppingTimes& times) {
        const auto time = [&](const Edge&, core::Seconds, core::Seconds) {
          return std::optional{times.time()};
        };
        const auto is_goal = [](Vertex v, core::Seconds) { return v == last; };
        return find_nearest_goal(graph, 0, core::Seconds{0.0}, core::Seconds{1e9}, time, is_goal,
                                 times.token())
            .tree.stopped;
      },
      expansions_between_looks);
}

TEST(StoppedSearches, LabelsTimesFewEdgesMore) {
  expect_few_edges_after_a_stop(
      [](StoppingTimes& times) {
        const StoppingVoyage voyage{times};
        return find_best_labels(graph, 0, last, 0.0, {}, voyage, 1'000'000, times.token()).stopped;
      },
      label_expansions_between_looks);
}

}  // namespace
}  // namespace floeplan::graph::stopped_searches_test

#include "engine/planning/search/isochrone_search.hpp"

#include <algorithm>
#include <cmath>

#include "engine/graph/label_search.hpp"
#include "engine/graph/time_dependent_astar.hpp"
#include "engine/planning/search/bounds/foresight.hpp"
#include "engine/planning/search/grid/grid_travel.hpp"

namespace floeplan::planning::search {
namespace {

using graph::Vertex;
using Direction = IsochroneRequest::Direction;

constexpr std::size_t most_arrivals = 4'000'000;
constexpr double spans_in_bound = 100.0;  // last surfacings are told apart to a hundredth of the limit

/// The model of `graph::find_best_labels` for a vehicle that goes as far as it can with a limited time
/// without surfacing. Times count on the search's clock (see `Presence`).
class BoundedVoyage {
 public:
  struct State {
    double surfaced_s{};  // time of the last possible surfacing
  };
  using Label = graph::Label<State>;

  BoundedVoyage(const cost::Sea& sea, const OpenGrid& open, Direction direction, core::Seconds latest)
      : sea_{sea},
        grid_{open.grid},
        bound_{sea, open.grid, open.graph, open.grid.start},
        direction_{direction},
        latest_{latest},
        longest_s_{sea.domain().overhead().longest_without_surfacing()->count()},
        best_(open.graph.size()) {}

  void extend(const graph::Edge& edge, double arrival_s, const State& state, auto&& emit) {
    const geo::PlanePoint tail = grid_.point(edge.tail);
    const core::Seconds least_time = bound_.least_time(edge);
    const double least_s = arrival_s + least_time.count();
    if (least_s > latest_.count()) return;
    const bool stays_below = sea_.least_time_to_opening(tail) > least_time;
    if (stays_below && least_s - state.surfaced_s > longest_s_) return;
    if (is_beaten(edge.head, {least_s, stays_below ? state.surfaced_s : least_s})) return;

    const Presence here{core::Seconds{arrival_s}, core::Seconds{arrival_s - state.surfaced_s}};
    const auto there = go_on(sea_, direction_, tail, grid_.point(edge.head), here, latest_);
    if (!there || there->when > latest_) return;
    const Arrival arrival{there->when.count(), (there->when - there->from_surfacing).count()};
    if (is_beaten(edge.head, arrival)) return;
    std::erase_if(best_[edge.head], [&](const Arrival& other) { return is_no_worse(arrival, other); });
    best_[edge.head].push_back(arrival);
    emit(arrival.s, State{arrival.surfaced_s}, 0U);
  }

  void wait(Vertex, double, const State&, auto&&) const {}
  [[nodiscard]] double key(Vertex, double arrival_s, const State&) const { return arrival_s; }
  [[nodiscard]] bool dominates(Vertex, const Label& a, const Label& b) const {
    return is_no_worse({a.arrival_s, a.state.surfaced_s}, {b.arrival_s, b.state.surfaced_s});
  }

 private:
  struct Arrival {
    double s;
    double surfaced_s;
  };

  /// Whether `a` makes `b` needless: `a` is no later, and its last surfacing is no longer ago. Then `a` can
  /// go wherever `b` can within the limit.
  [[nodiscard]] bool is_no_worse(const Arrival& a, const Arrival& b) const {
    if (a.s > b.s) return false;
    return a.s - a.surfaced_s <= b.s - b.surfaced_s || span_of(a) >= span_of(b);
  }
  [[nodiscard]] bool is_beaten(Vertex v, const Arrival& arrival) const {
    return std::ranges::any_of(best_[v], [&](const Arrival& other) { return is_no_worse(other, arrival); });
  }
  [[nodiscard]] double span_of(const Arrival& arrival) const {
    return std::floor(spans_in_bound * arrival.surfaced_s / longest_s_);
  }

  const cost::Sea& sea_;
  const cost::RouteGrid& grid_;
  StraightBound bound_;
  Direction direction_;
  core::Seconds latest_;
  double longest_s_;
  std::vector<std::vector<Arrival>> best_;  // the best arrivals so far, for each vertex
};

/// Sharp lower bounds of the times of edges, and no goal.
struct ForesightEdges {
  Foresight& foresight;

  [[nodiscard]] core::Seconds least_time(const graph::Edge& edge, core::Seconds depart) const {
    return foresight.least_time(edge, depart);
  }
  [[nodiscard]] static core::Seconds remaining(Vertex) { return core::Seconds{0.0}; }
  [[nodiscard]] static core::Seconds latest_use(Vertex) { return core::Seconds{INFINITY}; }
};

graph::SearchTree search_without_bound(const cost::Sea& sea, const OpenGrid& open, Direction direction,
                                       core::Seconds begin, core::Seconds latest, const std::stop_token& stop,
                                       const graph::ExpansionCallback& report) {
  const graph::Query query{
      .source = open.grid.start, .goal = std::nullopt, .depart = begin, .latest = latest};
  if (direction == Direction::from) {
    Foresight foresight{sea, open};
    return graph::find_earliest_arrivals(open.graph, query, GridTravelTime{sea, open.grid}, stop,
                                         ForesightEdges{foresight}, report);
  }
  const StraightBound straight{sea, open.grid, open.graph, open.grid.start};
  return graph::find_earliest_arrivals(open.graph, query, GridTravelTimeBack{sea, open.grid}, stop,
                                       EdgeBound{straight}, report);
}

Reached reached_by(const graph::SearchTree& tree, std::size_t vertices) {
  Reached reached;
  for (Vertex v = 0; v < vertices; ++v) {
    reached.first.push_back(static_cast<std::uint32_t>(reached.presences.size()));
    if (tree.is_reached(v)) reached.presences.push_back({core::Seconds{tree.arrival_s(v)}, {}});
  }
  reached.first.push_back(static_cast<std::uint32_t>(reached.presences.size()));
  reached.edge_evaluations = tree.counters.edge_evaluations;
  reached.expansions = tree.counters.expansions;
  reached.stopped = tree.stopped;
  return reached;
}

Reached reached_by(const graph::LabelSearch<BoundedVoyage::State>& search, std::size_t vertices) {
  Reached reached;
  reached.first.assign(vertices + 1, 0);
  for (const auto& label : search.labels) ++reached.first[label.vertex + 1];
  for (std::size_t v = 0; v < vertices; ++v) reached.first[v + 1] += reached.first[v];
  reached.presences.resize(search.labels.size());
  std::vector<std::uint32_t> next{reached.first.begin(), reached.first.end() - 1};
  for (const auto& label : search.labels) {
    const core::Seconds when{label.arrival_s};
    reached.presences[next[label.vertex]++] = {when, when - core::Seconds{label.state.surfaced_s}};
  }
  for (std::size_t v = 0; v < vertices; ++v) {
    std::sort(reached.presences.begin() + reached.first[v], reached.presences.begin() + reached.first[v + 1],
              [](const Presence& a, const Presence& b) { return a.when < b.when; });
  }
  reached.edge_evaluations = search.counters.edge_evaluations;
  reached.expansions = search.counters.expansions;
  reached.stopped = search.stopped;
  reached.full = search.full;
  return reached;
}

}  // namespace

tl::expected<Presence, motion::EdgeClosed> go_on(const cost::Sea& sea, Direction direction,
                                                 geo::PlanePoint from, geo::PlanePoint to, Presence at,
                                                 core::Seconds latest) {
  const auto arrival = [&](core::Seconds time) { return Presence{at.when + time, core::Seconds{0.0}}; };
  if (!sea.domain().overhead().bounds_surfacing()) {
    return direction == Direction::from ? sea.leg_time(from, to, at.when, latest).map(arrival)
                                        : sea.leg_time_back(to, from, -at.when, -latest).map(arrival);
  }
  if (direction == Direction::from) {
    return sea.leg(from, to, at.when, at.from_surfacing).map([&](const cost::Sea::Leg& leg) {
      return Presence{at.when + leg.time, leg.since_surfacing};
    });
  }
  return sea.leg_back(to, from, -at.when, at.from_surfacing, -latest).map([&](const cost::Sea::LegBack& leg) {
    return Presence{at.when + leg.time, leg.until_surfacing};
  });
}

Reached find_reached(const cost::Sea& sea, const OpenGrid& open, Direction direction, core::Seconds begin,
                     core::Seconds latest, const std::stop_token& stop,
                     const graph::ExpansionCallback& report) {
  const std::size_t vertices = open.graph.size();
  if (!sea.domain().overhead().bounds_surfacing()) {
    return reached_by(search_without_bound(sea, open, direction, begin, latest, stop, report), vertices);
  }
  BoundedVoyage voyage{sea, open, direction, latest};
  const BoundedVoyage::State start{.surfaced_s = begin.count()};
  return reached_by(graph::find_best_labels(open.graph, open.grid.start, std::nullopt, begin.count(), start,
                                            voyage, most_arrivals, stop, report),
                    vertices);
}

}  // namespace floeplan::planning::search

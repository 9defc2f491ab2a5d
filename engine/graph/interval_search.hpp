#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <iterator>
#include <limits>
#include <optional>
#include <queue>
#include <stop_token>
#include <utility>
#include <vector>

#include "engine/graph/grid_graph.hpp"
#include "engine/graph/search_tree.hpp"

namespace floeplan::graph {

/// A period in which a place is safe. All times in this file are seconds from the
/// same zero as the departure of the query.
struct SafeInterval {
  double from_s{};
  double until_s{};
  bool may_stay{};  // true: the vehicle may stay there during the period; false: it may only pass
};

/// A departure at which an edge is open, and its arrival.
struct OpenDeparture {
  double depart_s{};
  double arrive_s{};
};

/// Result of a search for such a departure.
struct DepartureLook {
  std::optional<OpenDeparture> open;
  double looked_until_s{};  // no earlier departure is open
};

/// Edges that open and close, between places that are safe at times.
/// safe_intervals  of a vertex: ascending, disjoint; of two that touch, the vehicle may stay in at most one
/// first_open      the first departure between `from_s` and `until_s` that arrives at `arrive_from_s` or
/// later. One call may test only some departures; the next call continues from `looked_until_s` open_until
///   the last departure until which the edge stays open from `open` on, at most `until_s`, with an arrival of
/// at most `arrive_until_s`. It may stop earlier; the next call continues from there least_time_s    lower
/// bound of the edge's time, for all departures
/// remaining_s     lower bound from a vertex to the goal. Law (consistent): remaining(tail) <= time of the
/// edge + remaining(head)
/// Law (FIFO)      a later departure arrives later
/// Law (safe)      an open departure arrives in one of the head's intervals
template <class M>
concept IntervalModel = requires(M& model, const Edge& edge, Vertex v, double s, const OpenDeparture& open) {
  { model.safe_intervals(v) } -> std::same_as<std::vector<SafeInterval>>;
  { model.first_open(edge, s, s, s) } -> std::same_as<DepartureLook>;
  { model.open_until(edge, open, s, s) } -> std::same_as<OpenDeparture>;
  { model.least_time_s(edge) } -> std::convertible_to<double>;
  { model.remaining_s(v) } -> std::convertible_to<double>;
};

/// A vertex of the path, with arrival and departure.
struct Visit {
  Vertex vertex{};
  double arrive_s{};
  double leave_s{};
};

/// Result of a search over intervals.
struct IntervalSearch {
  std::vector<Visit> way;  // from the source to the goal; empty: no path
  SearchCounters counters;
  bool stopped{false};     // stopped by the caller: the result is incomplete
  bool full{false};        // a limit on memory or work was reached: an earlier path may exist
  double none_before_s{};  // if `full`: lower bound of the arrival

  [[nodiscard]] double arrival_s() const { return way.empty() ? SearchTree::never : way.back().arrive_s; }
};

/// Accuracy and limits of a search over intervals.
struct IntervalLimits {
  double slack_s{};  // tolerance: an arrival later than the earliest by this is good enough
  std::size_t most_entries{std::numeric_limits<std::uint32_t>::max()};  // some hundred bytes each
  std::int64_t most_looks{std::numeric_limits<std::int64_t>::max()};    // calls of first_open
};

/// The search of `find_earliest_among_intervals`, for one query.
template <class Graph, IntervalModel Model>
class IntervalSearcher {
 public:
  /// All references are borrowed.
  IntervalSearcher(const Graph& graph, const Query& query, Model& model, const IntervalLimits& limits)
      : graph_{graph}, query_{query}, goal_{query.goal.value()}, model_{model}, limits_{limits} {
    place_of_.assign(graph.size(), none);
  }

  IntervalSearch run(const std::stop_token& stop, const ExpansionCallback& report) && {
    begin();
    for (std::int64_t turn = 0; !queue_.empty() && !is_decided(); ++turn) {
      if (turn % turns_between_looks == 0) {
        if (stop.stop_requested()) {
          search_.stopped = true;
          return std::move(search_);
        }
        if (report && turn % turns_between_reports == 0) report(search_.counters.expansions);
      }
      if (queue_.size() + arrivals_.size() + stands_.size() > limits_.most_entries ||
          search_.counters.edge_evaluations > limits_.most_looks) {
        search_.full = true;
        search_.none_before_s = queue_.top().key_s;
        break;
      }
      const Entry entry = queue_.top();
      queue_.pop();
      if (entry.arrivals != none) {
        expand(entry.arrivals);
      } else {
        look_on(entry.traveller);
      }
    }
    if (best_ != none) trace_back();
    return std::move(search_);
  }

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  static constexpr std::int64_t turns_between_looks = 64;
  static constexpr std::int64_t turns_between_reports = 16'384;
  static constexpr double resolution_s = 0.1;  // tolerance of departures
  static constexpr double touching_s = 1.0;    // windows of arrivals closer than this are joined

  /// Arrivals at a place within one of its intervals. If the vehicle may stay there: the earliest one.
  /// Otherwise a window of arrivals.
  struct Arrivals {
    Vertex vertex;
    std::uint32_t interval;
    double from_s;
    double until_s;
    std::uint32_t parent;  // index of a stand; `none`: the start of the search
    std::uint8_t step;     // of the edge that leads here
    double depart_from_s;
    double depart_until_s;
    bool expanded{false};
    double
        known_until_s{};  // for windows: the latest end of it and of those that begin earlier in the interval
  };
  /// A place that a vehicle may leave at any time of a window.
  struct Stand {
    Vertex vertex;
    std::uint32_t interval;
    double from_s;
    double until_s;
  };
  /// Searches departures from one stand along one edge, in ascending order. They lead into an interval of the
  /// edge's head and into the intervals after it.
  struct Traveller {
    std::uint32_t stand;
    Edge edge;
    std::uint32_t interval;
    double depart_s;
    double arrive_s;      // lower limit of the arrival
    double earliest_s{};  // lower bound of the arrival at the head
  };
  /// Queue entry: arrivals to expand, or a traveller. Of equal keys the entry comes first that would be
  /// nearer to the goal without closures.
  struct Entry {
    double key_s;
    double order_s;
    std::uint64_t number;
    std::uint32_t arrivals;
    Traveller traveller;
    bool operator>(const Entry& other) const {
      if (key_s != other.key_s) return key_s > other.key_s;
      if (order_s != other.order_s) return order_s > other.order_s;
      return number > other.number;
    }
  };
  /// Search state of a place in one of its intervals.
  struct State {
    std::vector<std::uint32_t> arrivals;  // ascending; if the vehicle may stay, only the earliest
    bool settled{false};                  // expanded; only for intervals in which the vehicle may stay
  };
  struct Place {
    std::vector<SafeInterval> intervals;
    std::vector<State> states;
  };

  Place& place(Vertex v) {
    if (place_of_[v] == none) {
      place_of_[v] = static_cast<std::uint32_t>(places_.size());
      std::vector<SafeInterval> intervals = model_.safe_intervals(v);
      std::vector<State> states(intervals.size());
      places_.push_back({std::move(intervals), std::move(states)});
    }
    return places_[place_of_[v]];
  }

  void begin() {
    if (!graph_.is_open(query_.source)) return;
    const double depart_s = query_.depart.count();
    const std::vector<SafeInterval>& intervals = place(query_.source).intervals;
    for (std::uint32_t i = 0; i < intervals.size(); ++i) {
      if (depart_s < intervals[i].from_s || depart_s > intervals[i].until_s) continue;
      add({query_.source, i, depart_s, depart_s, none, 0, depart_s, depart_s});
    }
  }

  [[nodiscard]] bool is_decided() const {
    const double key_s = queue_.top().key_s;
    return key_s > query_.latest.count() ||
           (best_ != none && arrivals_[best_].from_s <= key_s + limits_.slack_s);
  }

  /// The earliest time, from `when_s` on, at which the goal is safe.
  double goal_opens_s(double when_s) {
    for (const SafeInterval& safe : place(goal_).intervals) {
      if (safe.until_s >= when_s) return std::max(when_s, safe.from_s);
    }
    return SearchTree::never;
  }

  void add(const Arrivals& arrivals) {
    if (arrivals.vertex == goal_ && arrivals.from_s > query_.latest.count()) return;
    State& state = place(arrivals.vertex).states[arrivals.interval];
    const auto index = static_cast<std::uint32_t>(arrivals_.size());
    if (place(arrivals.vertex).intervals[arrivals.interval].may_stay) {
      if (!state.arrivals.empty() && arrivals_[state.arrivals.front()].from_s <= arrivals.from_s) return;
      state.arrivals = {index};
      arrivals_.push_back(arrivals);
    } else {
      arrivals_.push_back(arrivals);
      insert_window(state, index);
    }
    if (arrivals.vertex == goal_) {
      if (best_ == none || arrivals.from_s < arrivals_[best_].from_s) best_ = index;
      return;
    }
    const double there_s = arrivals.from_s + model_.remaining_s(arrivals.vertex);
    push(goal_opens_s(there_s), there_s, index, {});
  }

  void push(double key_s, double order_s, std::uint32_t arrivals, const Traveller& traveller) {
    const bool is_late = !(key_s <= query_.latest.count()) || key_s >= SearchTree::never;
    if (is_late || (best_ != none && key_s >= arrivals_[best_].from_s)) return;
    queue_.push({key_s, order_s, number_++, arrivals, traveller});
  }

  void insert_window(State& state, std::uint32_t index) {
    const auto i = state.arrivals.insert(first_after(state, arrivals_[index].from_s), index);
    double known_until_s = arrivals_[index].until_s;
    if (i != state.arrivals.begin())
      known_until_s = std::max(known_until_s, arrivals_[*std::prev(i)].known_until_s);
    arrivals_[index].known_until_s = known_until_s;
    for (auto later = std::next(i);
         later != state.arrivals.end() && arrivals_[*later].known_until_s < known_until_s; ++later)
      arrivals_[*later].known_until_s = known_until_s;
  }

  /// For a place that can only be passed: the first window that begins after `time_s`.
  [[nodiscard]] auto first_after(const State& state, double time_s) const {
    return std::ranges::upper_bound(state.arrivals, time_s, {}, from_of());
  }
  [[nodiscard]] auto from_of() const {
    return [this](std::uint32_t i) { return arrivals_[i].from_s; };
  }

  void expand(std::uint32_t index) {
    const Arrivals from = arrivals_[index];
    if (from.expanded) return;
    Place& here = place(from.vertex);
    State& state = here.states[from.interval];
    Stand stand{from.vertex, from.interval, from.from_s, from.until_s};
    if (here.intervals[from.interval].may_stay) {
      if (state.settled || state.arrivals.front() != index) return;
      state.settled = true;
      stand.until_s = here.intervals[from.interval].until_s;
    } else {
      // Windows that touch are joined: many paths lead here at about the same time.
      const auto first = std::ranges::lower_bound(state.arrivals, stand.from_s, {}, from_of());
      for (auto i = first; i != state.arrivals.end(); ++i) {
        Arrivals& other = arrivals_[*i];
        if (other.expanded) continue;
        if (other.from_s > stand.until_s + touching_s) break;
        other.expanded = true;
        stand.until_s = std::max(stand.until_s, other.until_s);
      }
    }
    ++search_.counters.expansions;
    const auto number = static_cast<std::uint32_t>(stands_.size());
    stands_.push_back(stand);
    graph_.for_each_edge(from.vertex, [&](const Edge& edge) {
      queue_again({number, edge, 0, stand.from_s, -SearchTree::never});
    });
  }

  /// Queues the traveller again with the earliest arrival that it may still find, if that is of use.
  void queue_again(Traveller traveller) {
    const Stand& stand = stands_[traveller.stand];
    if (traveller.depart_s > stand.until_s) return;
    const Place& head = place(traveller.edge.head);
    const double least_s = model_.least_time_s(traveller.edge);
    traveller.earliest_s = std::max(traveller.depart_s + least_s, traveller.arrive_s);
    for (; traveller.interval < head.intervals.size(); ++traveller.interval) {
      const SafeInterval& safe = head.intervals[traveller.interval];
      if (safe.until_s < traveller.earliest_s || is_known(traveller)) continue;
      const double there_s = std::max(traveller.earliest_s, safe.from_s);
      const double remaining_s = model_.remaining_s(traveller.edge.head);
      push(goal_opens_s(there_s + remaining_s), stand.from_s + least_s + remaining_s, none, traveller);
      return;
    }
  }

  /// Whether the interval allows staying and another vehicle is there no later than this one could be.
  bool is_known(const Traveller& traveller) {
    const Place& head = place(traveller.edge.head);
    const SafeInterval& safe = head.intervals[traveller.interval];
    const State& state = head.states[traveller.interval];
    return safe.may_stay && !state.arrivals.empty() &&
           arrivals_[state.arrivals.front()].from_s <= std::max(traveller.earliest_s, safe.from_s);
  }

  void look_on(Traveller traveller) {
    const Stand stand = stands_[traveller.stand];
    const SafeInterval safe = place(traveller.edge.head).intervals[traveller.interval];
    if (is_known(traveller)) {  // another arrival came first in the meantime
      queue_again(traveller);
      return;
    }
    ++search_.counters.edge_evaluations;
    const DepartureLook look = model_.first_open(traveller.edge, traveller.depart_s, stand.until_s,
                                                 std::max(safe.from_s, traveller.arrive_s));
    if (!look.open) {
      if (look.looked_until_s >= stand.until_s) return;
      traveller.depart_s = look.looked_until_s;
      queue_again(traveller);
      return;
    }
    traveller.depart_s = look.open->depart_s;
    traveller.arrive_s = look.open->arrive_s;
    if (look.open->arrive_s > safe.until_s) {
      ++traveller.interval;
    } else if (safe.may_stay) {
      add({traveller.edge.head, traveller.interval, look.open->arrive_s, look.open->arrive_s, traveller.stand,
           traveller.edge.step, look.open->depart_s, look.open->depart_s});
      ++traveller.interval;
    } else {
      add_window(traveller, stand, safe, *look.open);
    }
    queue_again(traveller);
  }

  /// Adds the window of arrivals that begins with this departure, except for parts already known. Then moves
  /// the traveller past it.
  void add_window(Traveller& traveller, const Stand& stand, const SafeInterval& safe,
                  const OpenDeparture& open) {
    const State& state = place(traveller.edge.head).states[traveller.interval];
    const auto next = first_after(state, open.arrive_s + resolution_s);
    const double known_until_s =
        next == state.arrivals.begin() ? -SearchTree::never : arrivals_[*std::prev(next)].known_until_s;
    if (known_until_s > open.arrive_s + resolution_s) {
      traveller.arrive_s = known_until_s;
      return;
    }
    const double next_s = next == state.arrivals.end() ? SearchTree::never : arrivals_[*next].from_s;
    const OpenDeparture last =
        model_.open_until(traveller.edge, open, stand.until_s, std::min(safe.until_s, next_s));
    if (known_until_s < open.arrive_s - resolution_s || last.arrive_s > known_until_s + resolution_s) {
      add({traveller.edge.head, traveller.interval, open.arrive_s, last.arrive_s, traveller.stand,
           traveller.edge.step, open.depart_s, last.depart_s});
    }
    // The next search begins at the end of this window; if the window is a single moment, slightly later.
    const bool goes_on = last.depart_s > open.depart_s + resolution_s;
    traveller.depart_s = goes_on ? last.depart_s : last.depart_s + resolution_s;
    traveller.arrive_s = last.arrive_s;
  }

  /// Follows the path from the goal back. Each departure is the one whose arrival the next step of the path
  /// needs.
  void trace_back() {
    std::vector<Visit>& way = search_.way;
    std::uint32_t index = best_;
    double arrive_s = arrivals_[best_].from_s;
    way.push_back({goal_, arrive_s, arrive_s});
    while (arrivals_[index].parent != none) {
      const Arrivals& arrivals = arrivals_[index];
      const Stand& stand = stands_[arrivals.parent];
      const double leave_s = departure_for(arrivals, stand, arrive_s);
      const State& state = place(stand.vertex).states[stand.interval];
      const bool stays = place(stand.vertex).intervals[stand.interval].may_stay;
      index = state.arrivals.front();
      if (!stays) {
        index = *std::ranges::find_if(
            state.arrivals, [&](std::uint32_t i) { return arrivals_[i].until_s >= leave_s - resolution_s; });
      }
      arrive_s = stays ? arrivals_[index].from_s : std::max(leave_s, arrivals_[index].from_s);
      way.push_back({stand.vertex, arrive_s, std::max(leave_s, arrive_s)});
    }
    std::ranges::reverse(way);
  }

  double departure_for(const Arrivals& arrivals, const Stand& stand, double arrive_s) {
    if (arrive_s <= arrivals.from_s) return arrivals.depart_from_s;
    const Edge edge{stand.vertex, arrivals.vertex, arrivals.step};
    for (double depart_s = arrivals.depart_from_s; depart_s < arrivals.depart_until_s;) {
      const DepartureLook look = model_.first_open(edge, depart_s, arrivals.depart_until_s, arrive_s);
      if (look.open) return look.open->depart_s;
      depart_s = look.looked_until_s;
    }
    return arrivals.depart_until_s;
  }

  const Graph& graph_;
  const Query& query_;
  Vertex goal_;
  Model& model_;
  IntervalLimits limits_;
  std::vector<std::uint32_t> place_of_;  // for each vertex: index of its place, or `none`
  std::deque<Place> places_;             // in the order of their first use
  std::vector<Arrivals> arrivals_;
  std::vector<Stand> stands_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
  std::uint64_t number_{};
  std::uint32_t best_{none};  // index of the arrivals at the goal
  IntervalSearch search_;
};

/// The earliest arrival at the query's goal if places and edges open and close and a vehicle may stay at some
/// places for a while: A* over (vertex, safe interval). If the vehicle may stay, the earliest arrival can do
/// all that a later one can. If it can only pass, every arrival counts, so windows of arrivals are kept. A
/// closed edge is put back into the queue and tested again when the search reaches that time. Exact under the
/// model's laws, within the slack and a second per edge.
/// `graph`  as GridGraph: size, is_open, for_each_edge
/// Returns  a path whose departures are as late as the earliest arrival at each next place allows, so the
///          vehicle waits near what it waits for
/// Source   Phillips and Likhachev 2011, SIPP: Safe interval path planning for dynamic environments,
///          doi:10.1109/ICRA.2011.5980306; the windows of arrivals are an addition
/// Stops    early, and says so in the result, once `stop` is requested or a limit is reached; in the second
///          case with the best path so far, if there is one
template <class Graph, IntervalModel Model>
IntervalSearch find_earliest_among_intervals(const Graph& graph, const Query& query, Model& model,
                                             const IntervalLimits& limits, const std::stop_token& stop,
                                             const ExpansionCallback& report = {}) {
  return IntervalSearcher<Graph, Model>{graph, query, model, limits}.run(stop, report);
}

}  // namespace floeplan::graph

#pragma once

#include <algorithm>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <queue>
#include <stop_token>
#include <vector>

#include "engine/graph/grid_graph.hpp"
#include "engine/graph/search_tree.hpp"

namespace floeplan::graph {

/// An arrival at a vertex. `State` holds what matters for the way onward besides vertex and time.
template <class State>
struct Label {
  static constexpr std::uint32_t no_parent = std::numeric_limits<std::uint32_t>::max();

  Vertex vertex{};
  double arrival_s{};
  State state{};
  std::uint32_t parent{no_parent};  // index of the label before; after a wait it is at the same vertex
  std::uint32_t choice{};           // number, given by the model, of the kind of travel or wait that led here
};

/// Shape of the callback to which `extend` and `wait` report each arrival: emit(arrival_s, state, choice).
template <class State>
struct IgnoreArrival {
  void operator()(double, const State&, std::uint32_t) const {}
};

/// The rules by which labels are made and compared. Times are seconds on the clock of the query's departure.
/// extend     emits an arrival for every way to travel the edge at that time in that state; none if the edge
/// is closed wait       emits every later time at the vertex that is worth a wait; none if the vehicle cannot
/// stay key        cost so far plus a lower bound of the rest. Law: never falls along a path, never exceeds
/// the cost of any path to the goal, and at the goal equals the cost
/// order      optional: among labels with equal keys, the least comes first; meant for those nearest to the
/// goal dominates  whether all that can be done from `b` can be done from `a`, at the same vertex, at no
/// greater cost. A label after a wait is compared, too, also with the one before the wait
template <class M>
concept VoyageModel = requires(M& model, const Edge& edge, Vertex v, const Label<typename M::State>& label,
                               IgnoreArrival<typename M::State>& emit) {
  model.extend(edge, label.arrival_s, label.state, emit);
  model.wait(v, label.arrival_s, label.state, emit);
  { model.key(v, label.arrival_s, label.state) } -> std::convertible_to<double>;
  { model.dominates(v, label, label) } -> std::same_as<bool>;
};

struct LabelCounters {
  std::int64_t expansions{};
  std::int64_t edge_evaluations{};
  std::int64_t dominated{};  // arrivals dropped because another one dominates them
};

/// Result of a search over labels.
template <class State>
struct LabelSearch {
  std::vector<Label<State>> labels;   // in the order of creation, so parents come before children
  std::optional<std::uint32_t> goal;  // index of the best label at the goal; empty: no path found
  LabelCounters counters;
  double least_key{};   // lower bound of the cost of all paths not found
  bool stopped{false};  // stopped by the caller: the result is incomplete
  bool full{false};     // the limit on labels was reached: a further path may exist
};

/// Expansions between two checks of the stop token. One expansion may travel each edge in several ways and
/// past moving obstacles, which takes some hundred microseconds.
inline constexpr std::int64_t label_expansions_between_looks = 4;

/// Order among labels with equal keys, the least first; zero if the model has no `order`.
template <class M>
double order_of(const M& model, Vertex v, double arrival_s) {
  if constexpr (requires { model.order(v, arrival_s); }) {
    return model.order(v, arrival_s);
  } else {
    return 0.0;
  }
}

/// The best path from a source to a goal if more than the arrival time counts. Each vertex has several
/// labels, none of which dominates another. They are expanded by ascending key; equal keys by ascending
/// order, then by creation.
/// `goal`: empty: all vertices that the model reaches.
/// `slack`: tolerance in units of the key. With zero the result is exact under the model's laws.
/// Stops    early, and says so in the result, once `stop` is requested or `most_labels` have been made; in
///          the second case with the best path to the goal so far, if there is one
/// Source   Martins 1984, On a multicriteria shortest path problem, doi:10.1016/0377-2217(84)90077-8 (label
///          setting with several criteria); Phillips and Likhachev 2011, SIPP: Safe interval path planning
///          for dynamic environments, doi:10.1109/ICRA.2011.5980306 (a state that is a safe interval)
template <VoyageModel Model>
LabelSearch<typename Model::State> find_best_labels(const GridGraph& graph, Vertex source,
                                                    std::optional<Vertex> goal, double depart_s,
                                                    const typename Model::State& start, Model& model,
                                                    std::size_t most_labels, const std::stop_token& stop,
                                                    const ExpansionCallback& report = {},
                                                    double slack = 0.0) {
  using State = typename Model::State;
  constexpr std::uint32_t none = Label<State>::no_parent;
  struct Open {
    double key;
    double order_s;  // of equal keys the least comes first
    std::uint32_t label;
    auto operator<=>(const Open&) const = default;
  };

  LabelSearch<State> search;
  std::vector<std::uint32_t> newest(graph.size(), none);  // first undominated label of each vertex
  std::vector<std::uint32_t> next;                        // for each label: next in that list
  std::vector<bool> dominated;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> queue;
  std::optional<Open> best;  // best label at the goal
  if (!graph.is_open(source)) return search;

  const auto add = [&](const Label<State>& label) {
    for (std::uint32_t i = newest[label.vertex]; i != none; i = next[i]) {
      if (!model.dominates(label.vertex, search.labels[i], label)) continue;
      ++search.counters.dominated;
      return;
    }
    if (search.labels.size() >= std::min<std::size_t>(most_labels, none)) {
      search.full = true;
      return;
    }
    for (std::uint32_t* link = &newest[label.vertex]; *link != none;) {
      if (model.dominates(label.vertex, label, search.labels[*link])) {
        ++search.counters.dominated;
        dominated[*link] = true;
        *link = next[*link];
      } else {
        link = &next[*link];
      }
    }
    const auto index = static_cast<std::uint32_t>(search.labels.size());
    search.labels.push_back(label);
    next.push_back(newest[label.vertex]);
    dominated.push_back(false);
    newest[label.vertex] = index;
    const Open open{model.key(label.vertex, label.arrival_s, label.state),
                    order_of(model, label.vertex, label.arrival_s), index};
    if (label.vertex == goal && (!best || open.key < best->key)) best = open;
    queue.push(open);
  };

  add({.vertex = source, .arrival_s = depart_s, .state = start});
  while (!queue.empty() && !search.full) {
    if (search.counters.expansions % label_expansions_between_looks == 0) {
      if (stop.stop_requested()) {
        search.stopped = true;
        break;
      }
      if (report && search.counters.expansions % 1024 == 0) report(search.counters.expansions);
    }
    if (best && best->key <= queue.top().key + slack) break;
    search.least_key = queue.top().key;
    const std::uint32_t parent = queue.top().label;
    queue.pop();
    if (dominated[parent]) continue;
    ++search.counters.expansions;
    const Label<State> from = search.labels[parent];  // a copy, because the vector grows below
    graph.for_each_edge(from.vertex, [&](const Edge& edge) {
      ++search.counters.edge_evaluations;
      model.extend(edge, from.arrival_s, from.state,
                   [&](double arrival_s, const State& state, std::uint32_t choice) {
                     add({edge.head, arrival_s, state, parent, choice});
                   });
    });
    model.wait(from.vertex, from.arrival_s, from.state,
               [&](double arrival_s, const State& state, std::uint32_t choice) {
                 add({from.vertex, arrival_s, state, parent, choice});
               });
  }
  if (best && !search.stopped) search.goal = best->label;
  return search;
}

/// The labels from the source to this one, both included.
template <class State>
std::vector<Label<State>> way_to(const LabelSearch<State>& search, std::uint32_t label) {
  std::vector<Label<State>> way;
  for (std::uint32_t i = label; i != Label<State>::no_parent; i = search.labels[i].parent) {
    way.push_back(search.labels[i]);
  }
  std::ranges::reverse(way);
  return way;
}

}  // namespace floeplan::graph

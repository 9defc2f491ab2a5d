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

/// An arrival at a place in a state: what `State` holds matters for the way onward besides place and time.
template <class State>
struct Label {
  static constexpr std::uint32_t no_parent = std::numeric_limits<std::uint32_t>::max();

  Vertex vertex{};
  double arrival_s{};
  State state{};
  std::uint32_t parent{no_parent};  // index of the label it comes from, at the same vertex after a wait
  std::uint32_t choice{};           // which of the model's ways to travel or to wait led here
};

/// Where `extend` and `wait` report each arrival: emit(arrival_s, state, choice).
template <class State>
struct IgnoreArrival {
  void operator()(double, const State&, std::uint32_t) const {}
};

/// The rules of a voyage. Times are seconds on the clock of the query's departure.
/// extend     every way to travel the edge when at its tail then and in that state; none when it is closed
/// wait       every later moment worth staying for at the vertex; none where the vehicle cannot stay
/// key        cost so far and a bound on the rest. Law: never falls along a way, never more than the cost of
///            any way to the goal, and at the goal the cost itself
/// order      if there is one: the labels likely to be nearest to the goal first, among those whose keys are equal
/// dominates  whether whatever can be done from `b` can be done from `a`, at the same vertex, at no greater
///            cost. A label after a wait is compared too, also with the one it waited from
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
  std::int64_t dominated{};  // arrivals that were of no use, because another one dominates them
};

/// What a search over labels made.
template <class State>
struct LabelSearch {
  std::vector<Label<State>> labels;   // in the order they were made, so a parent comes before its children
  std::optional<std::uint32_t> goal;  // index of the best label at the goal; empty: no way found
  LabelCounters counters;
  double least_key{};   // no way that was not found costs less
  bool stopped{false};  // the caller asked for it: what is here is not complete
  bool full{false};     // the bound on labels was met: a way may exist that was not found
};

/// How often a search over labels looks at its stop token: an expansion may travel each edge in several ways
/// and past moving obstacles, some hundred microseconds in all.
inline constexpr std::int64_t label_expansions_between_looks = 4;

/// Rank of a label among labels with equal keys, the least first; zero if the model gives no `order`.
template <class M>
double order_of(const M& model, Vertex v, double arrival_s) {
  if constexpr (requires { model.order(v, arrival_s); }) {
    return model.order(v, arrival_s);
  } else {
    return 0.0;
  }
}

/// The best way from a source to a goal where more than the arrival time counts: several labels for each
/// vertex, of which none dominates another, expanded by ascending key, of equal keys by ascending order and then as the
/// labels were made.
/// `goal`: empty: everywhere, as far as the model goes.
/// `slack`: in units of the key, a way that costs no more than the best by so much will do; exact under the model's
/// laws without it.
/// Stops    early, and says so in the result, once `stop` is requested or `most_labels` have been made; in the second
///          case with the best way to the goal so far, if there is one
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
    double order_s;  // of equal keys the least goes first
    std::uint32_t label;
    auto operator<=>(const Open&) const = default;
  };

  LabelSearch<State> search;
  std::vector<std::uint32_t> newest(graph.size(), none);  // of each vertex's undominated labels, a list
  std::vector<std::uint32_t> next;                        // in that list, for each label
  std::vector<bool> dominated;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> queue;
  std::optional<Open> best;  // at the goal
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
    const Label<State> from = search.labels[parent];  // a copy: the list grows below
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

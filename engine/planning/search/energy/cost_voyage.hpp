#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include "engine/graph/label_search.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/problem/objective.hpp"
#include "engine/planning/search/bounds/arrival_ladder.hpp"
#include "engine/planning/search/energy/cost_outlook.hpp"
#include "engine/planning/search/grid/open_grid.hpp"

namespace floeplan::planning::search {

/// The model for `graph::find_best_labels` if energy counts. Each edge is travelled with every propulsion
/// that the request allows. The choice stored in a label is the index of the propulsion in `Sea::drives()`.
/// Accuracy  In steady currents the result is exact on the grid; if the time without surfacing is limited, to
///           ten minutes of that time. In changing currents an arrival is dropped for another one that costs
///           no more and does not lie in a later span of ten minutes. So the cheapest route may be missed
///           where a later departure from a place makes the rest of the route cheaper, or open, by more than
///           the wait cost. If the time without surfacing is limited, an arrival is dropped only for another
///           whose last surfacing lies in the same part of that limit or a later one
/// Threads   const members may be called from several threads at once
class CostVoyage {
 public:
  struct State {
    double cost{};        // by the objective, since the departure
    double surfaced_s{};  // time of the last possible surfacing, if that is limited
  };

  /// Bounds that are known before the search. They change no result.
  struct Limit {
    double most_cost{};       // cost of a route that is known to be possible
    ArrivalLadder* ladder{};  // reaches the latest arrival that this cost allows; borrowed
  };

  /// `sea`, `open` and `outlook` are borrowed and must outlive this object.
  /// `outlook`: steers the search. The search is then quick, and its cost exceeds the least by at most the
  /// error of the outlook.
  CostVoyage(const cost::Sea& sea, const OpenGrid& open, const Objective& objective,
             const std::optional<Limit>& limit = std::nullopt, const CostOutlook* outlook = nullptr);

  /// The least possible cost per second of any route.
  [[nodiscard]] static double least_rate(const cost::Sea& sea, const Objective& objective);

  void extend(const graph::Edge& edge, double arrival_s, const State& state, auto&& emit) const {
    const geo::PlanePoint tail = grid_.point(edge.tail);
    const geo::PlanePoint head = grid_.point(edge.head);
    double latest_s = INFINITY;
    if (limit_) {
      const double least_s = limit_->ladder->least_time_s(edge, arrival_s);
      if (!is_worthwhile(edge.head, arrival_s + least_s, state.cost + least_rate_ * least_s)) return;
      latest_s = limit_->ladder->latest_use_s(edge.head);
    }
    for (std::uint32_t choice = 0; choice < sea_.drives().size(); ++choice) {
      const vehicle::Drive drive = sea_.drives()[choice];
      const auto travelled = travel(tail, head, arrival_s, state.surfaced_s, latest_s, drive);
      if (!travelled || !can_surface_in_time(edge.head, travelled->leg.since_surfacing)) continue;
      const cost::Sea::Leg& leg = travelled->leg;
      const double encounters = sea_.encounters(tail, head, core::Seconds{arrival_s}, leg.time);
      const double cost = state.cost + objective_.cost(leg.time, travelled->energy.total(), encounters);
      const double head_s = arrival_s + leg.time.count();
      if (limit_ && !is_worthwhile(edge.head, head_s, cost)) continue;
      emit(head_s, State{.cost = cost, .surfaced_s = head_s - leg.since_surfacing.count()}, choice);
    }
  }

  void wait(graph::Vertex, double, const State&, auto&&) const {}

  [[nodiscard]] double key(graph::Vertex v, double arrival_s, const State& state) const;

  [[nodiscard]] bool dominates(graph::Vertex, const graph::Label<State>& a,
                               const graph::Label<State>& b) const {
    if (a.state.cost > b.state.cost) return false;
    // In steady currents only the time since the last surfacing matters, not the time of day.
    if (steady_)
      return !longest_without_surfacing_ || span(since_surfacing_s(a)) <= span(since_surfacing_s(b));
    return surfaced_as_late(a, b) && span(a.arrival_s) <= span(b.arrival_s);
  }

 private:
  /// Lower bound of the cost of the rest of the route.
  [[nodiscard]] double rest(graph::Vertex v, double arrival_s) const;
  [[nodiscard]] bool is_worthwhile(graph::Vertex v, double arrival_s, double cost) const {
    return cost + rest(v, arrival_s) <= limit_->most_cost;
  }
  static double span(double time_s) { return std::floor(time_s / 600.0); }
  static double since_surfacing_s(const graph::Label<State>& label) {
    return label.arrival_s - label.state.surfaced_s;
  }

  [[nodiscard]] tl::expected<cost::Sea::MeteredLeg, motion::EdgeClosed> travel(
      geo::PlanePoint tail, geo::PlanePoint head, double arrival_s, double surfaced_s, double latest_s,
      vehicle::Drive drive) const;
  /// Whether a vehicle can reach a place to surface, or the last stop, within the limit on the time without
  /// surfacing.
  [[nodiscard]] bool can_surface_in_time(graph::Vertex v, core::Seconds since_surfacing) const;
  [[nodiscard]] bool surfaced_as_late(const graph::Label<State>& a, const graph::Label<State>& b) const;

  const cost::Sea& sea_;
  const cost::RouteGrid& grid_;
  core::Seconds least_after_goal_;
  Objective objective_;
  std::optional<Limit> limit_;
  const CostOutlook* outlook_;
  double least_rate_;
  geo::PlanePoint goal_;
  std::optional<core::Seconds> longest_without_surfacing_;  // limit; empty: none applies
  bool steady_;                                             // currents and closures do not change with time
};

}  // namespace floeplan::planning::search

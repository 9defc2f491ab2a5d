#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "engine/graph/label_search.hpp"
#include "engine/planning/cost/hold_times.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/cost/surfacing_watch.hpp"
#include "engine/planning/search/bounds/arrival_ladder.hpp"
#include "engine/planning/search/bounds/openings.hpp"
#include "engine/planning/search/grid/open_grid.hpp"
#include "engine/planning/search/grid/vertex_closures.hpp"
#include "engine/planning/search/surfacing/surfacing_reach.hpp"

namespace floeplan::planning::search {

/// The best arrivals so far at each vertex of a grid. Two properties count: the time of the arrival (earlier
/// is better) and the span of time of its last possible surfacing (later is better).
class SurfacingFronts {
 public:
  explicit SurfacingFronts(std::size_t vertices) : fronts_(vertices) {}

  [[nodiscard]] bool holds_better(graph::Vertex v, double arrival_s, std::int64_t span) const;
  void add(graph::Vertex v, double arrival_s, std::int64_t span);

 private:
  struct Arrival {
    double s;
    std::int64_t span;
  };
  std::vector<std::vector<Arrival>> fronts_;
};

/// The model of `graph::find_best_labels` for a vehicle with a limit on the time since the last possible
/// surfacing.
/// Resolution  Of two arrivals the earlier one is better, unless its last possible surfacing lies in an
///             earlier span of time. Below ice the last surfacing stays the same, so a route loses at most
///             one span between two surfacings, however many arrivals replace each other
/// Closures  Near something that reopens, only arrivals within the same step of time are compared. The step
///           is the time that the vehicle needs for a step of the grid
/// Threads  one search at a time
class SurfacingVoyage {
 public:
  struct State {
    double surfaced_s{};     // time of the last possible surfacing
    std::size_t interval{};  // number of closures of the vertex that are over; used if the vehicle may hold
  };
  using Label = graph::Label<State>;

  /// Tables for the grid made before the search. All are borrowed and must outlive this object.
  struct Known {
    VertexClosures& closures;
    const Openings& openings;
    const SurfacingReach& reach;
    ArrivalLadder* ladder;  // sharper bounds that change no result; null: the bound of a straight line
  };
  enum class Aim {
    best_way,
    any_way  // quickly: the remaining time counts double (weighted A*); an arrival earlier by less than a
             // step of the grid is no better; times since the last surfacing are compared, not times of
             // surfacing
  };
  /// `resolution`: width of the spans of last surfacings. `before`: only earlier arrivals at the goal count.
  /// `weight`: factor of the remaining time, at least 1. The result takes at most this factor times the least
  /// time (weighted A*).
  SurfacingVoyage(const cost::Sea& sea, const OpenGrid& open, const Known& known, core::Seconds resolution,
                  core::Seconds before, Aim aim = Aim::best_way, double weight = 1.0);

  void extend(const graph::Edge& edge, double arrival_s, const State& state, auto&& emit) {
    const geo::PlanePoint tail = grid_.point(edge.tail);
    const geo::PlanePoint head = grid_.point(edge.head);
    const double least_s = least_arrival_s(edge, arrival_s);
    if (!is_of_use(edge.head, least_s)) return;
    const bool stays_below = !may_surface_along(tail, head);
    if (stays_below && !can_surface_in_time(edge.head, least_s - state.surfaced_s)) return;
    if (may_wait_) return extend_with_waits(edge, arrival_s, state, emit);
    if (stays_below && is_beaten(edge.head, least_s, span_of(state.surfaced_s, least_s))) return;

    const core::Seconds since{arrival_s - state.surfaced_s};
    const auto leg = sea_.leg(tail, head, core::Seconds{arrival_s}, since);
    if (!leg) return;
    const double head_s = arrival_s + leg->time.count();
    const double surfaced_s = stays_below ? state.surfaced_s : head_s - leg->since_surfacing.count();
    if (!is_of_use(edge.head, head_s) || !can_surface_in_time(edge.head, head_s - surfaced_s)) return;
    const bool at_surface = leg->since_surfacing.count() == 0.0;
    const std::int64_t span = at_surface ? latest_span : span_of(surfaced_s, head_s);
    if (is_beaten(edge.head, head_s, span)) return;
    fronts_.add(edge.head, head_s, span);
    emit(head_s, State{.surfaced_s = surfaced_s}, 0U);
  }

  void wait(graph::Vertex, double, const State&, auto&&) const {}

  [[nodiscard]] bool may_wait() const { return may_wait_; }
  [[nodiscard]] double key(graph::Vertex v, double arrival_s, const State&) const {
    if (aim_ == Aim::best_way) return arrival_s + weight_ * (earliest_at_goal_s(v, arrival_s) - arrival_s);
    return arrival_s + any_weight * sea_.least_time(grid_.point(v), goal_).count();
  }

  [[nodiscard]] double order(graph::Vertex, double arrival_s) const { return -arrival_s; }

  /// Whether `a` is as good as `b` in all respects, so that `b` can be dropped. In changing currents the
  /// later of two vehicles under ice may catch up. So their last surfacings are compared, not the times since
  /// then.
  [[nodiscard]] bool dominates(graph::Vertex v, const Label& a, const Label& b) const {
    if (a.arrival_s > b.arrival_s + indifferent_s_) return false;
    if (may_wait_) return may_wait_for(v, a, b);
    if (openings_.matter(v, b.arrival_s) && step_of(a.arrival_s) != step_of(b.arrival_s)) return false;
    return a.state.surfaced_s == a.arrival_s ||
           span_of(a.state.surfaced_s, a.arrival_s) >= span_of(b.state.surfaced_s, b.arrival_s);
  }

 private:
  static constexpr std::int64_t latest_span = std::numeric_limits<std::int64_t>::max();
  /// In tests around the ice of the demonstration data a weight of 2 needed fewer labels than 1.5. A weight
  /// of 3 needed still fewer there, but more where there is no route.
  static constexpr double any_weight = 2.0;

  [[nodiscard]] double earliest_at_goal_s(graph::Vertex v, double arrival_s) const;
  [[nodiscard]] std::int64_t span_of(double surfaced_s, double arrival_s) const;
  [[nodiscard]] double step_of(double arrival_s) const { return std::floor(arrival_s / step_s_); }
  /// Whether another arrival so far is better than this one for every route onward.
  [[nodiscard]] bool is_beaten(graph::Vertex v, double arrival_s, std::int64_t span) const {
    return !openings_.matter(v, arrival_s) && fronts_.holds_better(v, arrival_s + indifferent_s_, span);
  }
  /// Lower bound in seconds of the arrival at the head of the edge, for a departure from its tail at
  /// `depart_s`.
  [[nodiscard]] double least_arrival_s(const graph::Edge& edge, double depart_s) const;
  [[nodiscard]] bool is_of_use(graph::Vertex v, double arrival_s) const;
  [[nodiscard]] bool may_surface_along(geo::PlanePoint tail, geo::PlanePoint head) const;
  /// Whether the vehicle can still surface, or reach its last stop, within the limit. At the goal the part of
  /// the limit that the rest of the route needs must be left.
  [[nodiscard]] bool can_surface_in_time(graph::Vertex v, double since_surfacing_s) const;
  /// Whether the vehicle of `first` can hold until `other` arrives and is then no worse off.
  [[nodiscard]] bool may_wait_for(graph::Vertex v, const Label& first, const Label& other) const;
  /// Emits labels at the head of the edge: without a hold, and after the shortest hold for each later
  /// interval between closures of the head.
  void extend_with_waits(const graph::Edge& edge, double arrival_s, const State& state, auto&& emit);

  const cost::Sea& sea_;
  const cost::RouteGrid& grid_;
  geo::PlanePoint goal_;
  VertexClosures& closures_;
  const Openings& openings_;
  const SurfacingReach& reach_;
  ArrivalLadder* ladder_;
  double step_s_;
  double longest_s_;
  double left_at_goal_s_;
  double resolution_s_;
  double before_s_;
  Aim aim_;
  double weight_;
  bool may_wait_;
  double indifferent_s_;  // a later arrival within this time counts as equal
  SurfacingFronts fronts_;
};

void SurfacingVoyage::extend_with_waits(const graph::Edge& edge, double arrival_s, const State& state,
                                        auto&& emit) {
  const geo::PlanePoint tail = grid_.point(edge.tail);
  const geo::PlanePoint head = grid_.point(edge.head);
  const std::vector<TimeSpan>& closed = closures_.at(edge.head);
  const core::Seconds arrive{arrival_s};
  cost::for_each_opening(
      sea_, tail, head, closed, arrive, core::Seconds{before_s_}, [&](const cost::WaitedLeg& leg) {
        const core::Seconds leaves = arrive + leg.wait;
        const auto since = cost::since_surfacing_after_wait(sea_.domain().overhead(), tail, arrive, leaves,
                                                            core::Seconds{arrival_s - state.surfaced_s});
        if (!since) return;
        const auto drive = sea_.leg(tail, head, leaves, *since);
        if (!drive) return;
        const core::Seconds there = leaves + drive->time;
        if (!is_of_use(edge.head, there.count())) return;
        if (!can_surface_in_time(edge.head, drive->since_surfacing.count())) return;
        emit(there.count(), State{(there - drive->since_surfacing).count(), cost::interval_of(closed, there)},
             0U);
      });
}

}  // namespace floeplan::planning::search

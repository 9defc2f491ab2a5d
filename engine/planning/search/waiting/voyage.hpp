#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "engine/graph/label_search.hpp"
#include "engine/planning/cost/route_grid.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/search/bounds/arrival_ladder.hpp"
#include "engine/planning/search/waiting/openings.hpp"

namespace floeplan::planning::search {

/// What a glider carries through a search besides place and time. A member that a request does not ask for
/// stays zero, and then plays no part in which arrival dominates which.
struct VoyageState {
  double energy_j{};
  double since_surfacing_s{};
  std::uint32_t interval{};  // which of the place's times between timed closures
};

/// The rules of a glider's voyage over a grid: the model of `graph::find_best_labels`.
/// Closures  near what opens again, an earlier arrival dominates a later one only within the same span of time, the
///           time the vehicle needs for a step of the grid; elsewhere always. So arriving later can be the only way
///           through, and is found to within that span
/// Threads   for one search, which it remembers the arrivals of
class Voyage {
 public:
  using State = VoyageState;

  /// `latest`: an arrival at the goal that is not before it is of no use. `ladder`: bounds up to that arrival that
  /// change no result; null: a straight line's. Everything is borrowed and outlives the voyage.
  Voyage(const cost::Sea& sea, const cost::RouteGrid& grid, const Openings& openings, core::Seconds latest,
         ArrivalLadder* ladder = nullptr);

  void extend(const graph::Edge& edge, double arrival_s, const State& state, auto&& emit) {
    const geo::PlanePoint tail = grid_.point(edge.tail);
    const geo::PlanePoint head = grid_.point(edge.head);
    double latest_s = latest_s_ - sea_.least_time(head, goal_).count();
    double least_s = arrival_s;
    if (ladder_ != nullptr) {
      latest_s = std::min(latest_s, ladder_->latest_use_s(edge.head));
      least_s += ladder_->least_time_s(edge, arrival_s);
    } else {
      least_s += sea_.least_time(tail, head).count();
    }
    if (least_s > latest_s || is_dominated(edge.head, least_s, latest_s)) return;
    const core::Seconds arrive{arrival_s};
    const auto time = sea_.leg_time(tail, head, arrive, core::Seconds{latest_s});
    if (!time) return;
    const double there_s = (arrive + *time).count();
    if (there_s >= latest_s) return;
    earliest_s_[edge.head] = std::min(earliest_s_[edge.head], there_s);
    emit(there_s, state, 0U);
  }

  void wait(graph::Vertex, double, const State&, auto&&) const {}

  [[nodiscard]] double key(graph::Vertex v, double arrival_s, const State&) const {
    if (v == grid_.goal) return arrival_s;
    const double straight_s = opens_s(arrival_s + sea_.least_time(grid_.point(v), goal_).count());
    return ladder_ != nullptr ? std::max(straight_s, ladder_->earliest_s(v, arrival_s)) : straight_s;
  }

  /// Time is killed under way, and the latest arrival is the one that came nearest.
  [[nodiscard]] static double order(graph::Vertex, double arrival_s) { return -arrival_s; }

  [[nodiscard]] bool dominates(graph::Vertex v, const graph::Label<State>& a,
                               const graph::Label<State>& b) const;

 private:
  /// Whether an arrival between the two, whenever it is, is of no use beside those that there were before.
  [[nodiscard]] bool is_dominated(graph::Vertex v, double first_s, double last_s) const {
    return earliest_s_[v] <= first_s && !openings_.matter(v, first_s, last_s);
  }
  /// The earliest arrival at the goal, as far as it is closed then.
  [[nodiscard]] double opens_s(double when_s) const;

  const cost::Sea& sea_;
  const cost::RouteGrid& grid_;
  const Openings& openings_;
  geo::PlanePoint goal_;
  double latest_s_;
  double span_s_;
  ArrivalLadder* ladder_;
  std::vector<double> earliest_s_;  // arrival so far, by vertex
};

}  // namespace floeplan::planning::search

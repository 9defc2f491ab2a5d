#pragma once

#include <cstdint>
#include <vector>

#include "engine/graph/label_search.hpp"
#include "engine/planning/route_grid.hpp"
#include "engine/planning/sea.hpp"

namespace floeplan::planning {

/// What a glider carries through a search besides place and time. A member that a request does not ask for
/// stays zero, and then plays no part in which arrival dominates which.
struct VoyageState {
  double energy_j{};
  double since_surfacing_s{};
  std::uint32_t interval{};  // which of the place's times between timed closures
};

/// The rules of a glider's voyage over a grid: the model of `graph::find_best_labels`.
/// Threads  one search at a time
class Voyage {
 public:
  using State = VoyageState;

  /// `sea` and `grid` are borrowed and outlive the voyage.
  Voyage(const Sea& sea, const RouteGrid& grid);

  void extend(const graph::Edge& edge, double arrival_s, const State& state, auto&& emit) const {
    const auto time = sea_.leg_time(grid_.point(edge.tail), grid_.point(edge.head), core::Seconds{arrival_s});
    if (time) emit(arrival_s + time->count(), state, 0U);
  }

  void wait(graph::Vertex, double, const State&, auto&&) const {}

  [[nodiscard]] double key(graph::Vertex v, double arrival_s, const State&) const {
    return arrival_s + sea_.least_time(grid_.point(v), grid_.point(grid_.goal)).count();
  }

  [[nodiscard]] bool dominates(graph::Vertex v, const graph::Label<State>& a,
                               const graph::Label<State>& b) const;

 private:
  const Sea& sea_;
  const RouteGrid& grid_;
};

}  // namespace floeplan::planning

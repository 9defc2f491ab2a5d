#pragma once

#include <cstddef>
#include <stop_token>
#include <vector>

#include "engine/planning/cost/sea.hpp"
#include "engine/planning/problem/objective.hpp"
#include "engine/planning/search/bounds/arrival_ladder.hpp"
#include "engine/planning/search/bounds/foresight.hpp"
#include "engine/planning/search/grid/open_grid.hpp"

namespace floeplan::planning::search {

/// Estimate of the cost of the rest of a route, for an objective of time and energy, from each vertex of a
/// grid at any time. It guides the search for the least cost. It is computed backwards from the goal, one
/// time slice after another, from quick estimates of all edges. It ignores closures between vertices and the
/// cost of encounters.
/// Accuracy  mostly within some hundredths of the cost of the grid's edges, too high or too low: not a bound
/// Source    Bellman 1957, Dynamic Programming: value iteration on a grid of places and times, linear between
///           the times
/// Threads   const members may be called from several threads at once
class CostOutlook {
 public:
  /// For routes between `depart` and `last`. `foresight`, which must be useful, belongs to the same grid; `use`
  /// gives the latest useful times of its vertices. Both are used only during construction. Once `stop` is
  /// requested the outlook must not be used.
  CostOutlook(const cost::Sea& sea, const OpenGrid& open, const Objective& objective, Foresight& foresight,
              const ArrivalLadder& use, core::Seconds depart, core::Seconds last,
              const std::stop_token& stop);

  /// Estimated cost from the vertex at `t_s` to the goal, by the objective; infinite where no route was
  /// found.
  [[nodiscard]] double rest(graph::Vertex v, double t_s) const { return between(slices_.at(t_s), v); }

 private:
  /// A time between two slices, for interpolation.
  struct Moment {
    std::size_t before;
    float share;  // of the step to the next slice
  };
  /// Times at equal steps.
  struct Slices {
    double first_s;
    double step_s;
    std::size_t count;  // at least two

    [[nodiscard]] core::Seconds time(std::size_t slice) const {
      return core::Seconds{first_s + static_cast<double>(slice) * step_s};
    }
    [[nodiscard]] Moment at(double t_s) const;
  };
  static Slices lay_slices(core::Seconds depart, core::Seconds last, std::size_t vertices);
  [[nodiscard]] float between(Moment moment, graph::Vertex v) const;

  std::size_t vertices_;
  Slices slices_;
  std::vector<float> rest_;  // [slice][vertex]
};

}  // namespace floeplan::planning::search

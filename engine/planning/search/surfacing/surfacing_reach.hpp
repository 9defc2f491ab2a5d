#pragma once

#include <stop_token>
#include <vector>

#include "engine/planning/cost/sea.hpp"
#include "engine/planning/search/grid/open_grid.hpp"

namespace floeplan::planning::search {

/// Lower bound of the time from each vertex to a place where the vehicle may surface, or to its last stop, with the
/// strongest current around each place astern. Infinite if it exceeds the limit.
/// Precondition  the time without surfacing is bounded
/// Stops  early once `stop` is requested; the times must then not be used
[[nodiscard]] std::vector<double> least_until_surfacing_s(const cost::Sea& sea, const OpenGrid& open,
                                                          const std::stop_token& stop);

/// The part of a grid where a route can keep the limit on the time without surfacing. It uses lower bounds of the
/// time since the last possible surfacing and of the time to the next one at each vertex, with the strongest current
/// around each place astern: first with the ice of the whole period, then hour by hour. What is closed by these
/// bounds is closed for every such vehicle.
/// Threads  const members may be called from several threads at once
class SurfacingReach {
 public:
  /// `since_surfacing`: at the departure from the start. Precondition: the time without surfacing is bounded. Once
  /// `stop` is requested the object stays incomplete and must not be used.
  SurfacingReach(const cost::Sea& sea, const OpenGrid& open, core::Seconds depart,
                 core::Seconds since_surfacing, const std::stop_token& stop);

  /// Whether a route to the goal may exist. If not, no route keeps the limit.
  [[nodiscard]] bool has_hope() const { return has_hope_; }
  /// The part of the grid where routes that keep the limit may lead: from the start to the goal or, if the goal
  /// cannot be reached, to wherever they end.
  [[nodiscard]] const OpenGrid& grid() const { return grid_; }
  /// Lower bound of the time from the vertex to a place where the vehicle may surface, or to its last stop.
  [[nodiscard]] double least_until_opening_s(graph::Vertex v) const { return until_s_[v]; }

 private:
  /// Which vertices are left.
  [[nodiscard]] std::vector<bool> find_ways(const cost::Sea& sea, const OpenGrid& open, core::Seconds depart,
                                            core::Seconds since_surfacing, const std::stop_token& stop);

  bool has_hope_{false};
  OpenGrid grid_;
  std::vector<double> until_s_;
};

}  // namespace floeplan::planning::search

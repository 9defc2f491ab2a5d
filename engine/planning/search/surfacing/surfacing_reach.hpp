#pragma once

#include <stop_token>
#include <vector>

#include "engine/planning/cost/sea.hpp"
#include "engine/planning/search/grid/open_grid.hpp"

namespace floeplan::planning::search {

/// Lower bound in seconds of the time from each vertex to a place where the vehicle may surface, or to its
/// last stop, with the strongest current around each place from astern. Infinite if it exceeds the limit.
/// Precondition  the time without surfacing is limited
/// Stops  early once `stop` is requested; the times must then not be used
[[nodiscard]] std::vector<double> least_until_surfacing_s(const cost::Sea& sea, const OpenGrid& open,
                                                          const std::stop_token& stop);

/// The part of a grid where a route can keep the limit on the time without surfacing. At each vertex it uses
/// lower bounds of the time since the last possible surfacing and of the time to the next one, with the
/// strongest current around each place from astern: first with the ice of the whole period, then hour by
/// hour. A vertex that these bounds exclude cannot be on any route that keeps the limit.
/// Threads  const members may be called from several threads at once
class SurfacingReach {
 public:
  /// `since_surfacing`: time since the last possible surfacing, at the departure from the start.
  /// Precondition: the time without surfacing is limited. Once `stop` is requested the object stays
  /// incomplete and must not be used.
  SurfacingReach(const cost::Sea& sea, const OpenGrid& open, core::Seconds depart,
                 core::Seconds since_surfacing, const std::stop_token& stop);

  /// Whether a route to the goal may exist. If not, no route keeps the limit.
  [[nodiscard]] bool has_hope() const { return has_hope_; }
  /// The part of the grid where routes that keep the limit may lead: from the start to the goal or, if the goal
  /// cannot be reached, to wherever they end.
  [[nodiscard]] const OpenGrid& grid() const { return grid_; }
  /// Lower bound in seconds of the time from the vertex to a place where the vehicle may surface, or to its
  /// last stop.
  [[nodiscard]] double least_until_opening_s(graph::Vertex v) const { return until_s_[v]; }

 private:
  /// The vertices that a route within the limit may use. Also sets `until_s_` and `has_hope_`.
  [[nodiscard]] std::vector<bool> find_ways(const cost::Sea& sea, const OpenGrid& open, core::Seconds depart,
                                            core::Seconds since_surfacing, const std::stop_token& stop);

  bool has_hope_{false};
  OpenGrid grid_;
  std::vector<double> until_s_;
};

}  // namespace floeplan::planning::search

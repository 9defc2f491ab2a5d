#pragma once

#include <stop_token>
#include <vector>

#include "engine/planning/cost/sea.hpp"
#include "engine/planning/search/grid/open_grid.hpp"

namespace floeplan::planning::search {

/// Never more than the time from each vertex to where the vehicle may surface or has come to its last stop, with the
/// strongest current about each place astern; infinite where it is longer than the bound.
/// Precondition: the sea bounds that time.
/// Stops  early once `stop` is requested; the times must then not be used
[[nodiscard]] std::vector<double> least_until_surfacing_s(const cost::Sea& sea, const OpenGrid& open,
                                                          const std::stop_token& stop);

/// Where on a grid the bound on the time without surfacing leaves a way at all: how long ago the last possible
/// surfacing lies at each vertex at least, and how long it takes to the next one, with the strongest current about each
/// place astern, in the ice of the whole period; then hour by hour. What is closed to such a vehicle is closed to every
/// one.
/// Threads  const members may be called from several threads at once
class SurfacingReach {
 public:
  /// `since_surfacing`: at the start, when it is left. Precondition: the sea bounds that time. Once `stop` is requested
  /// this stays incomplete and must not be used.
  SurfacingReach(const cost::Sea& sea, const OpenGrid& open, core::Seconds depart,
                 core::Seconds since_surfacing, const std::stop_token& stop);

  /// Whether there may be a way to the goal. If not, none keeps the bound.
  [[nodiscard]] bool has_hope() const { return has_hope_; }
  /// What is left of the grid: where ways may lead that keep the bound, from the start to the goal or, without hope, to
  /// wherever they end.
  [[nodiscard]] const OpenGrid& grid() const { return grid_; }
  /// Never more than the time from the vertex to where the vehicle may surface, or to its last stop.
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

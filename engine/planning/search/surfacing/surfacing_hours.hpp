#pragma once

#include <stop_token>
#include <vector>

#include "engine/planning/cost/sea.hpp"
#include "engine/planning/search/bounds/favourable_grid.hpp"

namespace floeplan::planning::search {

/// The vertices that a vehicle with a limit on the time without surfacing may reach.
struct HourlyReach {
  bool reaches_goal{false};
  /// One value per vertex. If `reaches_goal` is false: all vertices that can be reached before the ice data
  /// end.
  std::vector<bool> reached;
};

/// Divides the time from the departure on into spans. For one span after the other it finds where a vehicle may
/// surface within it, where it can go from there before it must surface again, and in which spans it may do so. Ice
/// that has closed, or opens only later, is thus not counted as open. Spans after the last one from which the goal
/// can be reached are skipped.
/// Law      a vehicle that keeps the limit is at no vertex that is not reached
/// Accuracy a span is half the limit wide, more if the period would have too many of them. A lead counts as open for
/// its whole span, and surfacings as possible until the limit after its end
/// Stops    early once `stop` is requested; the result must then not be used
[[nodiscard]] HourlyReach reach_hour_by_hour(const cost::Sea& sea, const FavourableGrid& grid,
                                             core::Seconds depart, core::Seconds since_surfacing,
                                             const std::stop_token& stop);

}  // namespace floeplan::planning::search

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

/// Divides the time from the departure on into spans. For each span in turn it finds the places where a vehicle
/// may surface, the places that it can reach from there before it must surface again, and the spans in which it may
/// do so. So water that has closed, or reopens only later, does not count as open. Spans after the last one from
/// which the goal can be reached are skipped.
/// Law      a vehicle that keeps the limit is only at vertices that are reached
/// Accuracy a span is half the limit wide, more if the period would have too many of them. A lead counts as open for
/// its whole span, and surfacings as possible until the limit after its end
/// Stops    early once `stop` is requested; the result must then not be used
[[nodiscard]] HourlyReach reach_hour_by_hour(const cost::Sea& sea, const FavourableGrid& grid,
                                             core::Seconds depart, core::Seconds since_surfacing,
                                             const std::stop_token& stop);

}  // namespace floeplan::planning::search

#pragma once

#include <stop_token>
#include <vector>

#include "engine/planning/cost/sea.hpp"
#include "engine/planning/search/bounds/favourable_grid.hpp"

namespace floeplan::planning::search {

/// Where a bound on the time without surfacing may let a vehicle come.
struct HourlyReach {
  bool reaches_goal{false};
  /// Of each vertex; not complete where the goal is among them, and all where it is too late for the goal before the
  /// period ends.
  std::vector<bool> reached;
};

/// Divides the time from the departure on into spans and asks of one after the other where a vehicle may surface within
/// it, where it may come from there before it has to surface again, and in which spans it may do so. So ice that has
/// closed is of no use any more, and what opens only later is of none yet. What comes after the last span from which
/// the goal can be reached is not asked.
/// Law      whoever keeps the bound is at no vertex that is not reached
/// Accuracy a span is half the bound wide, more where the period would have too many of them: openings count as there
///          for a span, and surfacings as possible until the bound after its end
/// Stops    early once `stop` is requested; the result must then not be used
[[nodiscard]] HourlyReach reach_hour_by_hour(const cost::Sea& sea, const FavourableGrid& grid,
                                             core::Seconds depart, core::Seconds since_surfacing,
                                             const std::stop_token& stop);

}  // namespace floeplan::planning::search

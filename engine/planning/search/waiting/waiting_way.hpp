#pragma once

#include <stop_token>
#include <vector>

#include "engine/graph/search_tree.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/search/grid/open_grid.hpp"

namespace floeplan::planning::search {

/// A way on which the vehicle spends time at one place.
struct WaitingWay {
  std::vector<geo::PlanePoint> path;  // start and goal included; empty: none was found
  core::Seconds arrival{};            // at its end
  graph::SearchCounters counters;
  bool cancelled{false};
};

/// When a way is to be at the goal.
struct ArrivalSpan {
  core::Seconds after;   // nothing is earlier
  core::Seconds before;  // what is later is of no use; finite
};

/// Looks for a way that goes on at once to some place, stays there, and is at the goal soon: by a search from the
/// start, which tells how early the vehicle can be at each place, and searches from the goal on the film run backwards,
/// which tell how late it may leave each for an arrival then; by halving, the arrival becomes earlier. The vehicle
/// turns in circles there: out and back on one line.
/// Precondition  the vehicle may not wait
/// Among much that opens and closes this finds in seconds what a search of all arrivals at all places loses itself in;
/// it is no proof that nothing is earlier.
[[nodiscard]] WaitingWay search_way_with_one_wait(const cost::Sea& sea, const OpenGrid& open,
                                                  core::Seconds depart, ArrivalSpan within,
                                                  const std::stop_token& stop);

}  // namespace floeplan::planning::search

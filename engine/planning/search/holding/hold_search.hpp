#pragma once

#include <cmath>
#include <stop_token>
#include <vector>

#include "engine/graph/interval_search.hpp"
#include "engine/graph/search_tree.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/search/bounds/foresight.hpp"
#include "engine/planning/search/grid/open_grid.hpp"

namespace floeplan::planning::search {

/// The route of a vehicle that may hold until a closure ends.
struct HeldWay {
  std::vector<geo::PlanePoint>
      path;  // start and goal included; empty: none exists with the holds that the request allows
  core::Seconds arrival{INFINITY};  // at the end of the route
  graph::SearchCounters counters;
  std::int64_t leg_times{};  // about this number of leg times was computed
  bool cancelled{false};
  bool full{false};             // a limit of memory or work was reached: an earlier route may exist
  core::Seconds none_before{};  // if `full`: lower bound of the arrival
};

/// Average number of leg times that it takes to find one open departure; measured in a tidal strait.
inline constexpr std::int64_t leg_times_of_a_look = 6;

/// An arrival may be later than the earliest by this tolerance.
[[nodiscard]] core::Seconds slack_of_holds(const cost::Sea& sea, const OpenGrid& open);

/// Limits of one search: about 300 MB, and about fifteen seconds in strong tides.
inline constexpr graph::IntervalLimits limits_of_a_hold_search{.most_entries = 3'000'000,
                                                               .most_looks = 2'000'000};

/// Searches a grid for the earliest arrival at its goal, at most `latest`, of a vehicle that may hold for any
/// time. If the route found needs a longer hold at one place than the request allows, there is no result. The
/// search cannot limit holds itself: the vehicle could move from place to place to keep each hold short. The
/// limit on the time without surfacing is ignored.
/// `foresight` of this grid, kept between searches. It does not change the result.
/// Stops  early once `stop` is requested, and says so
[[nodiscard]] HeldWay search_held_way(const cost::Sea& sea, const OpenGrid& open, Foresight& foresight,
                                      core::Seconds depart, core::Seconds latest, const std::stop_token& stop,
                                      const graph::ExpansionCallback& report = {},
                                      graph::IntervalLimits limits = limits_of_a_hold_search);

}  // namespace floeplan::planning::search

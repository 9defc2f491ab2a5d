#pragma once

#include <cmath>
#include <stop_token>
#include <vector>

#include "engine/graph/interval_search.hpp"
#include "engine/graph/search_tree.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/search/grid/open_grid.hpp"

namespace floeplan::planning::search {

/// The way of a vehicle that holds where something in its way is closed for a while.
struct HeldWay {
  std::vector<geo::PlanePoint> path;  // start and goal included; empty: none with holds as allowed
  core::Seconds arrival{INFINITY};    // at its end
  graph::SearchCounters counters;
  std::int64_t leg_times{};  // that were worked out, about
  bool cancelled{false};
  bool full{false};             // a bound on memory or work was met: an earlier way may exist
  core::Seconds none_before{};  // then: no way arrives earlier
};

/// Leg times for one look for an open departure, on the average; measured in a tidal strait.
inline constexpr std::int64_t leg_times_of_a_look = 6;

/// An arrival that is later than the earliest by so much will do.
[[nodiscard]] core::Seconds slack_of_holds(const cost::Sea& sea, const OpenGrid& open);

/// Some 300 MB, and in strong tides some fifteen seconds.
inline constexpr graph::IntervalLimits limits_of_a_hold_search{.most_entries = 3'000'000,
                                                               .most_looks = 2'000'000};

/// Searches a grid for the earliest arrival at its goal, no later than `latest`, of a vehicle that may hold for as
/// long as it must. A way that needs a longer hold at one place than the request allows counts as none. Shorter holds
/// are not searched for: the vehicle could hop from place to place to keep each of them short.
/// The time without surfacing counts as unbounded.
/// Stops  early and says so once `stop` is requested
[[nodiscard]] HeldWay search_held_way(const cost::Sea& sea, const OpenGrid& open, core::Seconds depart,
                                      core::Seconds latest, const std::stop_token& stop,
                                      const graph::ExpansionCallback& report = {},
                                      graph::IntervalLimits limits = limits_of_a_hold_search);

}  // namespace floeplan::planning::search

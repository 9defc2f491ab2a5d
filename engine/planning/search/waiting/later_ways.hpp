#pragma once

#include <cmath>
#include <cstddef>
#include <stop_token>
#include <vector>

#include "engine/graph/label_search.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/search/grid/open_grid.hpp"

namespace floeplan::planning::search {

/// A way that arrives later somewhere than it could, to pass what opens again.
struct LaterWay {
  std::vector<geo::PlanePoint> path;  // start and goal included; empty: none was found
  core::Seconds arrival{};            // at its end
  graph::LabelCounters counters;
  bool cancelled{false};
  bool cut_short{false};                 // the bound on labels was met: a better way may exist
  core::Seconds none_before{-INFINITY};  // no way that was not found arrives earlier
};

/// Searches a grid for the earliest arrival at its goal before `latest` among all ways, also those that arrive
/// somewhere later than they could. Nothing where nothing that is closed opens again before that.
/// `slack`: a way that arrives no later than the earliest by so much will do. Nobody waits, whatever the sea allows.
/// Stops    early and says so once `stop` is requested or `most_labels` arrivals are kept, some ten microseconds each
[[nodiscard]] LaterWay search_later_ways(const cost::Sea& sea, const OpenGrid& open, core::Seconds depart,
                                         core::Seconds latest, core::Seconds slack, std::size_t most_labels,
                                         const std::stop_token& stop);

}  // namespace floeplan::planning::search

#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <stop_token>
#include <tl/expected.hpp>
#include <vector>

#include "engine/graph/search_tree.hpp"
#include "engine/motion/edge_closed.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/problem/isochrone_request.hpp"
#include "engine/planning/search/grid/open_grid.hpp"

namespace floeplan::planning::search {

/// When a vehicle is at a place, on the clock of an isochrone search. Forwards the clock shows the time since
/// the epoch of the leg cost model. In a time-reversed search it shows that time negated, and the last
/// possible surfacing becomes the next one.
struct Presence {
  core::Seconds when{};
  core::Seconds from_surfacing{};  // time since the last possible surfacing; zero if that time is not limited
};

/// Follows the straight leg from `from` to `to` for a vehicle that is at `from` as in `at`. The leg may end
/// after `latest` only if the time without surfacing is limited.
/// Errors  as Sea::leg and Sea::leg_back
[[nodiscard]] tl::expected<Presence, motion::EdgeClosed> go_on(const cost::Sea& sea,
                                                               IsochroneRequest::Direction direction,
                                                               geo::PlanePoint from, geo::PlanePoint to,
                                                               Presence at, core::Seconds latest);

/// The result of an isochrone search.
struct Reached {
  std::vector<Presence> presences;   // ordered by vertex, then by time
  std::vector<std::uint32_t> first;  // index of each vertex's first presence; one more entry at the end
  std::int64_t edge_evaluations{};
  std::int64_t expansions{};
  bool stopped{false};  // stopped by the caller: incomplete
  bool full{false};     // the limit on arrivals was reached: further places may be reachable

  /// All presences at the vertex. Several only if the time without surfacing is limited: a later arrival may
  /// have surfaced more recently.
  [[nodiscard]] std::span<const Presence> at(graph::Vertex v) const {
    return {presences.data() + first[v], presences.data() + first[v + 1]};
  }
  /// Earliest arrival at the vertex in seconds; infinite if it was not reached.
  [[nodiscard]] double earliest_s(graph::Vertex v) const {
    return at(v).empty() ? std::numeric_limits<double>::infinity() : at(v).front().when.count();
  }
};

/// Searches a grid from its start at `begin` for all places that can be reached by `latest`.
/// Accuracy  If the time without surfacing is limited, of two arrivals the earlier one counts as better if
///           its last possible surfacing is no longer ago, even where the later one would meet a faster
///           current. Last surfacings are distinguished to a hundredth of the limit, so a route that needs
///           all of it may be missed
/// Stops     early once `stop` is requested, and says so; with a limit also when some million arrivals are
///           kept, some hundred megabytes
[[nodiscard]] Reached find_reached(const cost::Sea& sea, const OpenGrid& open,
                                   IsochroneRequest::Direction direction, core::Seconds begin,
                                   core::Seconds latest, const std::stop_token& stop,
                                   const graph::ExpansionCallback& report);

}  // namespace floeplan::planning::search

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

/// A vehicle at a place, on the clock of an isochrone search. Forwards the clock shows the time since the epoch of
/// the leg cost model. Time-reversed it shows the negative time, and the last possible surfacing becomes the next
/// one.
struct Presence {
  core::Seconds when{};
  core::Seconds from_surfacing{};  // zero if the time without surfacing is not bounded
};

/// The straight leg onward from there. It ends after `latest` only if the time without surfacing is bounded.
/// Errors  as Sea::leg and Sea::leg_back
[[nodiscard]] tl::expected<Presence, motion::EdgeClosed> go_on(const cost::Sea& sea,
                                                               IsochroneRequest::Direction direction,
                                                               geo::PlanePoint from, geo::PlanePoint to,
                                                               Presence at, core::Seconds latest);

/// What an isochrone search reached.
struct Reached {
  std::vector<Presence> presences;   // ordered by vertex, then by time
  std::vector<std::uint32_t> first;  // index of each vertex's first presence, with one more at the end
  std::int64_t edge_evaluations{};
  std::int64_t expansions{};
  bool stopped{false};  // stopped by the caller: incomplete
  bool full{false};     // the limit on arrivals was reached: more places may be within reach

  /// Several if the time without surfacing is bounded: a later arrival may have surfaced later.
  [[nodiscard]] std::span<const Presence> at(graph::Vertex v) const {
    return {presences.data() + first[v], presences.data() + first[v + 1]};
  }
  /// Infinite if the vertex was not reached.
  [[nodiscard]] double earliest_s(graph::Vertex v) const {
    return at(v).empty() ? std::numeric_limits<double>::infinity() : at(v).front().when.count();
  }
};

/// Searches a grid from its start at `begin` for all places that can be reached by `latest`.
/// Accuracy  if the time without surfacing is bounded, an arrival that is earlier and whose last possible surfacing
///           is no longer ago counts as better, also where a later one would meet a faster current. Last surfacings
///           are distinguished to a hundredth of the bound, so a route that needs all of it may be missed
/// Stops     early once `stop` is requested, and says so; also when some million arrivals are kept with a bound, some
///           hundred megabytes
[[nodiscard]] Reached find_reached(const cost::Sea& sea, const OpenGrid& open,
                                   IsochroneRequest::Direction direction, core::Seconds begin,
                                   core::Seconds latest, const std::stop_token& stop,
                                   const graph::ExpansionCallback& report);

}  // namespace floeplan::planning::search

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

/// A vehicle at a place, on the clock of a search for reach: forwards it shows the time since the sea's epoch;
/// backwards it is that of the film run backwards, and what was the last possible surfacing is the next one.
struct Presence {
  core::Seconds when{};
  core::Seconds from_surfacing{};  // zero where the time without one is not bounded
};

/// The straight way on from there, which ends after `latest` only where the time without surfacing is bounded.
/// Errors  as Sea::leg and Sea::leg_back
[[nodiscard]] tl::expected<Presence, motion::EdgeClosed> go_on(const cost::Sea& sea,
                                                               IsochroneRequest::Direction direction,
                                                               geo::PlanePoint from, geo::PlanePoint to,
                                                               Presence at, core::Seconds latest);

/// Where a search for reach came.
struct Reached {
  std::vector<Presence> presences;   // by vertex, those of one vertex by time
  std::vector<std::uint32_t> first;  // of each vertex, and the end of the last one's
  std::int64_t edge_evaluations{};
  std::int64_t expansions{};
  bool stopped{false};  // the caller asked for it: what is here is not complete
  bool full{false};     // the bound on arrivals was met: more may be within reach

  /// Several where the time without surfacing is bounded: the later ones might have surfaced later.
  [[nodiscard]] std::span<const Presence> at(graph::Vertex v) const {
    return {presences.data() + first[v], presences.data() + first[v + 1]};
  }
  /// Infinite where it did not come.
  [[nodiscard]] double earliest_s(graph::Vertex v) const {
    return at(v).empty() ? std::numeric_limits<double>::infinity() : at(v).front().when.count();
  }
};

/// Searches a grid from its start at `begin` on, as far as vehicles come by `latest`.
/// Accuracy  where the time without surfacing is bounded, an arrival that is earlier and whose last possible surfacing
///           lies no longer ago is held to be better, also where a later one would meet a faster current; last
///           surfacings are told apart to a hundredth of the bound, and a way that needs all of it may be left out
/// Stops     early and says so once `stop` is requested, or when some million arrivals with a bound are kept, some
///           hundred megabytes
[[nodiscard]] Reached find_reached(const cost::Sea& sea, const OpenGrid& open,
                                   IsochroneRequest::Direction direction, core::Seconds begin,
                                   core::Seconds latest, const std::stop_token& stop,
                                   const graph::ExpansionCallback& report);

}  // namespace floeplan::planning::search

#pragma once

#include <algorithm>
#include <tl/expected.hpp>

#include "engine/graph/grid_graph.hpp"
#include "engine/motion/edge_closed.hpp"
#include "engine/planning/cost/route_grid.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/search/bounds/foresight.hpp"
#include "engine/planning/search/grid/grid_travel.hpp"

namespace floeplan::planning::search {

/// Edge travel times of a vehicle that may hold anywhere and for any time, the hold included. No vehicle of the
/// request arrives earlier. An edge that is closed at once is left when a drive at constant speed is clear, and
/// its head is reached when that is open.
/// Accuracy  where only the middle of an edge is closed: some seconds, the difference between the two drives
struct HoldAnywhereTime {
  const cost::Sea& sea;
  const cost::RouteGrid& grid;
  Foresight& foresight;
  core::Seconds until;  // later reopenings do not count
  RefusedEdges* refused{nullptr};

  tl::expected<core::Seconds, motion::EdgeClosed> operator()(const graph::Edge& edge, core::Seconds depart,
                                                             core::Seconds latest) const {
    const auto at_once = GridTravelTime{sea, grid, refused}(edge, depart, latest);
    const bool reopens = !at_once && (at_once.error() == motion::EdgeClosed::obstacle ||
                                      at_once.error() == motion::EdgeClosed::in_zone);
    if (!reopens) return at_once;
    const geo::PlanePoint tail = grid.point(edge.tail);
    const geo::PlanePoint head = grid.point(edge.head);
    const auto time = sea.leg_time_without_timed_closures(tail, head, depart, latest);
    if (!time) return time;
    const core::Seconds open = foresight.open_from(edge.head, depart + *time);
    if (open >= std::min(until, latest)) return at_once;
    if (open > depart + *time) return open - depart;
    const auto clear = sea.domain().closures().first_clear_departure(tail, head, *time, depart, until);
    if (!clear) return at_once;
    const auto later = sea.leg_time_without_timed_closures(tail, head, *clear, latest);
    if (!later) return later;
    return foresight.open_from(edge.head, *clear + *later) - depart;
  }
};

}  // namespace floeplan::planning::search

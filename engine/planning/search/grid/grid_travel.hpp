#pragma once

#include <cmath>
#include <cstddef>
#include <tl/expected.hpp>
#include <vector>

#include "engine/graph/grid_graph.hpp"
#include "engine/motion/edge_closed.hpp"
#include "engine/planning/cost/route_grid.hpp"
#include "engine/planning/cost/sea.hpp"

namespace floeplan::planning::search {

/// An edge that was closed by the current when a search reached its tail.
struct RefusedEdge {
  graph::Edge edge;
  core::Seconds when{};
};

/// The edges that a search found closed by the current, in the order of the search. At most `most` are kept.
struct RefusedEdges {
  static constexpr std::size_t most = 1'000'000;  // 24 MB
  std::vector<RefusedEdge> edges;
};

/// Returns `time` unchanged. If the current closes the edge, first adds the edge to `refused`, which may be
/// null.
inline tl::expected<core::Seconds, motion::EdgeClosed> note_refusal(
    RefusedEdges* refused, const graph::Edge& edge, core::Seconds depart,
    tl::expected<core::Seconds, motion::EdgeClosed> time) {
  if (!time && time.error() == motion::EdgeClosed::current_too_strong && refused != nullptr &&
      refused->edges.size() < RefusedEdges::most) {
    refused->edges.push_back({edge, depart});
  }
  return time;
}

/// Travel times of edges on the plane grid (wfunc in the paper). Borrows sea, grid and, if given, the list of
/// refused edges.
struct GridTravelTime {
  const cost::Sea& sea;
  const cost::RouteGrid& grid;
  RefusedEdges* refused{nullptr};

  tl::expected<core::Seconds, motion::EdgeClosed> operator()(const graph::Edge& edge, core::Seconds depart,
                                                             core::Seconds latest) const {
    return note_refusal(refused, edge, depart,
                        sea.leg_time(grid.point(edge.tail), grid.point(edge.head), depart, latest));
  }
};

/// Travel times of edges on the plane grid without closures that end or begin in time.
struct UntimedTravelTime {
  const cost::Sea& sea;
  const cost::RouteGrid& grid;
  RefusedEdges* refused{nullptr};

  tl::expected<core::Seconds, motion::EdgeClosed> operator()(const graph::Edge& edge, core::Seconds depart,
                                                             core::Seconds latest) const {
    return note_refusal(
        refused, edge, depart,
        sea.leg_time_without_timed_closures(grid.point(edge.tail), grid.point(edge.head), depart, latest));
  }
};

/// GridTravelTime for the time-reversed search, whose clock shows -t. The search's edge from tail to head
/// stands for the leg from head to tail that ends at the time -depart.
struct GridTravelTimeBack {
  const cost::Sea& sea;
  const cost::RouteGrid& grid;

  tl::expected<core::Seconds, motion::EdgeClosed> operator()(const graph::Edge& edge, core::Seconds depart,
                                                             core::Seconds latest) const {
    return sea.leg_time_back(grid.point(edge.head), grid.point(edge.tail), -depart, -latest);
  }
};

/// Lower bound of travel times: a straight line with the strongest current from astern all along.
struct StraightBound {
  const cost::Sea& sea;
  const cost::RouteGrid& grid;
  graph::Vertex target;
  std::vector<core::Seconds> least_times;  // of edges, by their steps

  StraightBound(const cost::Sea& the_sea, const cost::RouteGrid& the_grid, const graph::GridGraph& graph,
                graph::Vertex the_target)
      : sea{the_sea}, grid{the_grid}, target{the_target} {
    for (const graph::Offset offset : graph.offsets()) {
      least_times.push_back(
          sea.least_time({0.0, 0.0}, {offset.dx * grid.along.x_m + offset.dy * grid.across.x_m,
                                      offset.dx * grid.along.y_m + offset.dy * grid.across.y_m}));
    }
  }

  /// Lower bound of the time of an edge, for any departure.
  [[nodiscard]] core::Seconds least_time(const graph::Edge& edge, core::Seconds = {}) const {
    return least_times[edge.step];
  }
  [[nodiscard]] core::Seconds remaining(graph::Vertex v) const {
    return sea.least_time(grid.point(v), grid.point(target));
  }
  [[nodiscard]] static core::Seconds latest_use(graph::Vertex) { return core::Seconds{INFINITY}; }
};

/// Least times of edges for a vehicle that meets only the closures which never end: land, shallow water, unknown
/// depths and areas whose rule is always in force.
struct StandingTravelTime {
  const cost::Sea& sea;
  const cost::RouteGrid& grid;
  const StraightBound& straight;

  tl::expected<core::Seconds, motion::EdgeClosed> operator()(const graph::Edge& edge, core::Seconds,
                                                             core::Seconds) const {
    const auto closed = sea.domain().safety().closed_between(grid.point(edge.tail), grid.point(edge.head));
    if (closed) return tl::unexpected(*closed);
    return straight.least_time(edge);
  }
};

/// The edge bounds of `StraightBound` with zero for the rest of the route: the search becomes Dijkstra's.
struct EdgeBound {
  const StraightBound& straight;

  [[nodiscard]] core::Seconds least_time(const graph::Edge& edge, core::Seconds) const {
    return straight.least_time(edge);
  }
  [[nodiscard]] static core::Seconds remaining(graph::Vertex) { return core::Seconds{0.0}; }
  [[nodiscard]] static core::Seconds latest_use(graph::Vertex) { return core::Seconds{INFINITY}; }
};

}  // namespace floeplan::planning::search

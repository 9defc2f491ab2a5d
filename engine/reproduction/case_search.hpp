#pragma once

#include <cmath>
#include <optional>
#include <stop_token>
#include <vector>

#include "engine/graph/corridors.hpp"
#include "engine/graph/time_dependent_astar.hpp"
#include "engine/graph/tve_search.hpp"
#include "engine/motion/edge_time.hpp"
#include "engine/planning/optimal_control/timed_way.hpp"
#include "engine/reproduction/grid_case.hpp"

namespace floeplan::reproduction {

/// Searches one of the paper's cases in a current; case and current are borrowed.
template <motion::PlaneCurrent Current>
class CaseSearch {
 public:
  CaseSearch(const GridCase& searched, const Current& current, core::MetresPerSecond through_water,
             double tolerance)
      : case_{searched},
        current_{current},
        through_water_{through_water},
        tolerance_{tolerance},
        graph_{searched.graph()},
        query_{vertex(searched.grid.start), vertex(searched.grid.goal), core::Seconds{0.0}} {}

  /// The route that the search finds, with its true times. Empty: no route is found, or the route cannot be
  /// travelled at the true times.
  [[nodiscard]] std::optional<planning::optimal_control::TimedWay> fastest() const {
    const auto at_departure = [&](const graph::Edge& edge, core::Seconds, core::Seconds latest) {
      return edge_time(edge, query_.depart, latest);
    };
    const graph::SearchTree tree =
        case_.frozen ? graph::find_earliest_arrivals(graph_, query_, at_departure, std::stop_token{})
                     : graph::find_earliest_arrivals_tve(graph_, query_, edges(), std::stop_token{});
    const std::vector<graph::Vertex> path = graph::path_to(graph_, tree, *query_.goal);
    if (path.empty()) return std::nullopt;
    return planning::optimal_control::time_way(points_of(path), query_.depart, legs());
  }

  /// Routes through different corridors, the earliest first, at most `most`.
  [[nodiscard]] std::vector<std::vector<geo::PlanePoint>> corridors(std::size_t most) const {
    std::vector<std::vector<geo::PlanePoint>> ways;
    for (const auto& path : graph::find_corridors(graph_, query_, edges(), most)) {
      ways.push_back(points_of(path));
    }
    return ways;
  }

  [[nodiscard]] planning::optimal_control::LegTimer legs() const {
    return [this](geo::PlanePoint from, geo::PlanePoint to, core::Seconds depart) {
      const auto time = leg_time(from, to, depart, core::Seconds{INFINITY});
      return time ? std::optional{*time} : std::nullopt;
    };
  }

 private:
  [[nodiscard]] graph::Vertex vertex(Node node) const { return graph_.vertex(node.column, node.row); }
  [[nodiscard]] geo::PlanePoint point(graph::Vertex v) const {
    return case_.grid.point({graph_.column(v), graph_.row(v)});
  }
  [[nodiscard]] std::vector<geo::PlanePoint> points_of(const std::vector<graph::Vertex>& path) const {
    std::vector<geo::PlanePoint> points;
    points.reserve(path.size());
    for (const graph::Vertex v : path) points.push_back(point(v));
    return points;
  }

  [[nodiscard]] auto edges() const {
    return [this](const graph::Edge& edge, core::Seconds depart, core::Seconds latest) {
      return edge_time(edge, depart, latest);
    };
  }
  [[nodiscard]] tl::expected<core::Seconds, motion::EdgeClosed> edge_time(const graph::Edge& edge,
                                                                          core::Seconds depart,
                                                                          core::Seconds latest) const {
    return leg_time(point(edge.tail), point(edge.head), depart, latest);
  }
  [[nodiscard]] tl::expected<core::Seconds, motion::EdgeClosed> leg_time(geo::PlanePoint from,
                                                                         geo::PlanePoint to,
                                                                         core::Seconds depart,
                                                                         core::Seconds latest) const {
    if (!case_.is_open(from, to)) return tl::unexpected(motion::EdgeClosed::obstacle);
    const core::Metres length{geo::distance_m(from, to)};
    return motion::edge_time({from, to, length}, depart, through_water_, current_,
                             {.relative_tolerance = tolerance_}, latest);
  }

  const GridCase& case_;
  const Current& current_;
  core::MetresPerSecond through_water_;
  double tolerance_;
  graph::GridGraph graph_;
  graph::Query query_;
};

}  // namespace floeplan::reproduction

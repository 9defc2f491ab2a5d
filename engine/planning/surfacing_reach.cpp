#include "engine/planning/surfacing_reach.hpp"

#include <algorithm>
#include <limits>

#include "engine/planning/favourable_grid.hpp"
#include "engine/planning/surfacing_hours.hpp"

namespace floeplan::planning {
namespace {

using graph::Edge;
using graph::Vertex;

constexpr double never = std::numeric_limits<double>::infinity();
constexpr double rounding_s = 1e-3;  // of sums of times

/// All vertices to which steps lead.
template <class ForEachNext>
std::vector<bool> reached_from(Vertex first, std::size_t vertices, const ForEachNext& for_each_next) {
  std::vector<bool> reached(vertices, false);
  reached[first] = true;
  std::vector<Vertex> open{first};
  while (!open.empty()) {
    const Vertex from = open.back();
    open.pop_back();
    for_each_next(from, [&](Vertex to) {
      if (reached[to]) return;
      reached[to] = true;
      open.push_back(to);
    });
  }
  return reached;
}

}  // namespace

SurfacingReach::SurfacingReach(const Sea& sea, const OpenGrid& open, core::Seconds depart,
                               core::Seconds since_surfacing, const std::stop_token& stop)
    : grid_{open}, until_s_(open.graph.size(), never) {
  grid_.graph = open.graph.keeping(find_ways(sea, open, depart, since_surfacing, stop));
  grid_.vertices = grid_.graph.count_open_vertices();
  grid_.edges = grid_.graph.count_edges();
}

std::vector<bool> SurfacingReach::find_ways(const Sea& sea, const OpenGrid& open, core::Seconds depart,
                                            core::Seconds since_surfacing, const std::stop_token& stop) {
  const FavourableGrid grid{sea, open};
  const double longest_s = sea.longest_without_surfacing()->count() + rounding_s;
  std::vector<double> straight_s(open.graph.size());
  for (Vertex v = 0; v < open.graph.size(); ++v) {
    straight_s[v] = sea.least_time_to_opening(open.grid.point(v)).count();
    if (open.graph.is_open(v) && straight_s[v] <= grid.longest_straight_s()) until_s_[v] = straight_s[v];
  }
  std::vector<double> since_s = until_s_;
  since_s[open.grid.start] = std::min(since_s[open.grid.start], since_surfacing.count());
  until_s_[open.grid.goal] = 0.0;
  lower_times(since_s, longest_s, stop, [&](Vertex v, double time_s, const auto& visit) {
    grid.for_each_edge_from(v, [&](const Edge& edge, double edge_s) { visit(edge.head, time_s + edge_s); });
  });
  lower_times(until_s_, longest_s, stop, [&](Vertex v, double time_s, const auto& visit) {
    grid.for_each_edge_to(v, [&](const Edge& edge, double edge_s) { visit(edge.tail, time_s + edge_s); });
  });

  // Whoever surfaces on an edge needs to come to the opening only, and has come from nothing else.
  const auto is_usable = [&](const Edge& edge, double edge_s) {
    if (since_s[edge.tail] + edge_s + until_s_[edge.head] <= longest_s) return true;
    return straight_s[edge.tail] <= grid.straight_s(edge) &&
           since_s[edge.tail] + straight_s[edge.tail] <= longest_s &&
           straight_s[edge.head] + until_s_[edge.head] <= longest_s;
  };
  std::vector<bool> within =
      reached_from(open.grid.start, open.graph.size(), [&](Vertex v, const auto& visit) {
        grid.for_each_edge_from(v, [&](const Edge& edge, double edge_s) {
          if (is_usable(edge, edge_s)) visit(edge.head);
        });
      });
  has_hope_ = within[open.grid.goal];
  if (!has_hope_ || stop.stop_requested()) return within;
  HourlyReach hourly = reach_hour_by_hour(sea, grid, depart, since_surfacing, stop);
  has_hope_ = hourly.reaches_goal;
  if (!has_hope_) return std::move(hourly.reached);
  const std::vector<bool> leads_on =
      reached_from(open.grid.goal, open.graph.size(), [&](Vertex v, const auto& visit) {
        grid.for_each_edge_to(v, [&](const Edge& edge, double edge_s) {
          if (is_usable(edge, edge_s)) visit(edge.tail);
        });
      });
  for (Vertex v = 0; v < open.graph.size(); ++v) within[v] = within[v] && leads_on[v];
  return within;
}

}  // namespace floeplan::planning

#include "engine/planning/search/surfacing/surfacing_reach.hpp"

#include <algorithm>
#include <limits>

#include "engine/planning/search/bounds/favourable_grid.hpp"
#include "engine/planning/search/surfacing/surfacing_hours.hpp"

namespace floeplan::planning::search {
namespace {

using graph::Edge;
using graph::Vertex;

/// All vertices that can be reached from `first` by the steps of for_each_next(vertex, visit).
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

/// Lower bounds in seconds of the time from each vertex straight to a lead.
struct TimesToOpening {
  std::vector<double> straight_s;
  std::vector<double> near_s;  // the same where the lead is at most one edge away; infinite elsewhere
};

TimesToOpening times_to_opening(const cost::Sea& sea, const FavourableGrid& grid) {
  const OpenGrid& open = grid.open();
  TimesToOpening times{std::vector<double>(open.graph.size()),
                       std::vector<double>(open.graph.size(), never_s)};
  for (Vertex v = 0; v < open.graph.size(); ++v) {
    times.straight_s[v] = sea.least_time_to_opening(open.grid.point(v)).count();
    if (open.graph.is_open(v) && times.straight_s[v] <= grid.longest_straight_s())
      times.near_s[v] = times.straight_s[v];
  }
  return times;
}

/// Lowers the times from vertices to the next lead along the edges, starting from the vertices near a lead.
/// Results as `least_until_surfacing_s`.
void spread_backwards(std::vector<double>& until_s, const FavourableGrid& grid, double longest_s,
                      const std::stop_token& stop) {
  double& at_goal_s = until_s[grid.open().grid.goal];
  at_goal_s = std::min(at_goal_s, grid.open().least_after_goal.count());
  lower_times(until_s, longest_s, stop, [&](Vertex v, double time_s, const auto& visit) {
    grid.for_each_edge_to(v, [&](const Edge& edge, double edge_s) { visit(edge.tail, time_s + edge_s); });
  });
}

/// The limit on the time without surfacing in seconds, with room for rounding.
double longest(const cost::Sea& sea) {
  return sea.domain().overhead().longest_without_surfacing()->count() + rounding_of_times_s;
}

}  // namespace

std::vector<double> least_until_surfacing_s(const cost::Sea& sea, const OpenGrid& open,
                                            const std::stop_token& stop) {
  const FavourableGrid grid{sea, open};
  std::vector<double> until_s = times_to_opening(sea, grid).near_s;
  spread_backwards(until_s, grid, longest(sea), stop);
  return until_s;
}

SurfacingReach::SurfacingReach(const cost::Sea& sea, const OpenGrid& open, core::Seconds depart,
                               core::Seconds since_surfacing, const std::stop_token& stop)
    : grid_{open} {
  grid_.graph = open.graph.keeping(find_ways(sea, open, depart, since_surfacing, stop));
  grid_.vertices = grid_.graph.count_open_vertices();
  grid_.edges = grid_.graph.count_edges();
}

std::vector<bool> SurfacingReach::find_ways(const cost::Sea& sea, const OpenGrid& open, core::Seconds depart,
                                            core::Seconds since_surfacing, const std::stop_token& stop) {
  const FavourableGrid grid{sea, open};
  const double longest_s = longest(sea);
  const TimesToOpening times = times_to_opening(sea, grid);
  const std::vector<double>& straight_s = times.straight_s;
  until_s_ = times.near_s;
  std::vector<double> since_s = times.near_s;
  since_s[open.grid.start] = std::min(since_s[open.grid.start], since_surfacing.count());
  lower_times(since_s, longest_s, stop, [&](Vertex v, double time_s, const auto& visit) {
    grid.for_each_edge_from(v, [&](const Edge& edge, double edge_s) { visit(edge.head, time_s + edge_s); });
  });
  spread_backwards(until_s_, grid, longest_s, stop);

  // Two ways to keep the limit on an edge: without surfacing, or with a surfacing in a lead that the edge
  // passes.
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
  const HourlyReach hourly = reach_hour_by_hour(sea, grid, depart, since_surfacing, stop);
  has_hope_ = hourly.reaches_goal;
  if (!has_hope_) {
    for (Vertex v = 0; v < open.graph.size(); ++v) within[v] = within[v] && hourly.reached[v];
    return within;
  }
  const std::vector<bool> leads_on =
      reached_from(open.grid.goal, open.graph.size(), [&](Vertex v, const auto& visit) {
        grid.for_each_edge_to(v, [&](const Edge& edge, double edge_s) {
          if (is_usable(edge, edge_s)) visit(edge.tail);
        });
      });
  for (Vertex v = 0; v < open.graph.size(); ++v) within[v] = within[v] && leads_on[v];
  return within;
}

}  // namespace floeplan::planning::search

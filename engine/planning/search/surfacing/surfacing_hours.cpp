#include "engine/planning/search/surfacing/surfacing_hours.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace floeplan::planning::search {
namespace {

using graph::Edge;
using graph::Vertex;

constexpr double span_share = 0.5;      // width, as a share of the limit on the time without surfacing
constexpr std::size_t most_spans = 96;  // each takes some milliseconds on a grid of a planning area

/// Consecutive spans of time; the last one has no end.
class Spans {
 public:
  Spans(const cost::Sea& sea, const FavourableGrid& grid, core::Seconds depart, double longest_s)
      : sea_{sea}, depart_{depart}, longest_s_{longest_s} {
    const graph::GridGraph& graph = grid.open().graph;
    for (Vertex v = 0; v < graph.size(); ++v) points_.push_back(grid.open().grid.point(v));
    const double period_s = (sea.domain().ice()->last_step() - depart).count();
    width_s_ = std::max({span_share * longest_s, period_s / static_cast<double>(most_spans), 1.0});
    count_ = 1 + static_cast<std::size_t>(std::max(0.0, std::ceil(period_s / width_s_)));
  }

  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] double begins_s(std::size_t span) const { return width_s_ * static_cast<double>(span); }
  [[nodiscard]] double ends_s(std::size_t span) const {
    return span + 1 < count_ ? begins_s(span + 1) : never_s;
  }
  /// The last span in which a vehicle whose last surfacing was in `span` can surface again within the limit.
  [[nodiscard]] std::size_t last_after(std::size_t span) const {
    const auto more = static_cast<std::size_t>(std::ceil(longest_s_ / width_s_)) + 1;
    return std::min(span + more, count_ - 1);
  }
  /// Least time in seconds from each vertex to a place where the vehicle may surface at some time of the
  /// span.
  [[nodiscard]] std::vector<double> to_openings_s(std::size_t span) const {
    return to_openings_s(points_, span);
  }
  [[nodiscard]] std::vector<double> to_openings_s(const std::vector<geo::PlanePoint>& points,
                                                  std::size_t span) const {
    return sea_.least_times_to_opening_s(points, depart_ + core::Seconds{begins_s(span)},
                                         depart_ + core::Seconds{ends_s(span)});
  }

 private:
  const cost::Sea& sea_;
  core::Seconds depart_;
  double longest_s_;
  double width_s_{};
  std::size_t count_{};
  std::vector<geo::PlanePoint> points_;
};

/// Lower bound of the arrival at each vertex, in seconds from the departure.
std::vector<double> earliest_arrivals(const FavourableGrid& grid, const std::stop_token& stop) {
  std::vector<double> arrivals_s(grid.open().graph.size(), never_s);
  arrivals_s[grid.open().grid.start] = 0.0;
  lower_times(arrivals_s, never_s, stop, [&](Vertex v, double time_s, const auto& visit) {
    grid.for_each_edge_from(v, [&](const Edge& edge, double edge_s) { visit(edge.head, time_s + edge_s); });
  });
  return arrivals_s;
}

/// The last span from whose surfacings the goal can be reached within the limit; 0 if there is none.
std::size_t last_of_use(const Spans& spans, const FavourableGrid& grid, double longest_s,
                        const std::stop_token& stop) {
  std::vector<double> to_goal_s(grid.open().graph.size(), never_s);
  to_goal_s[grid.open().grid.goal] = 0.0;
  lower_times(to_goal_s, longest_s, stop, [&](Vertex v, double time_s, const auto& visit) {
    grid.for_each_edge_to(v, [&](const Edge& edge, double edge_s) { visit(edge.tail, time_s + edge_s); });
  });
  std::vector<geo::PlanePoint> near_goal;
  std::vector<double> left_s;
  for (Vertex v = 0; v < to_goal_s.size(); ++v) {
    if (to_goal_s[v] > longest_s) continue;
    near_goal.push_back(grid.open().grid.point(v));
    left_s.push_back(longest_s - to_goal_s[v]);
  }
  for (std::size_t span = spans.count() - 1; span > 0 && !stop.stop_requested(); --span) {
    const std::vector<double> to_openings_s = spans.to_openings_s(near_goal, span);
    for (std::size_t i = 0; i < left_s.size(); ++i)
      if (to_openings_s[i] <= left_s[i]) return span;
  }
  return 0;
}

}  // namespace

HourlyReach reach_hour_by_hour(const cost::Sea& sea, const FavourableGrid& grid, core::Seconds depart,
                               core::Seconds since_surfacing, const std::stop_token& stop) {
  const OpenGrid& open = grid.open();
  const double longest_s = sea.domain().overhead().longest_without_surfacing()->count() + rounding_of_times_s;
  HourlyReach result{.reached = std::vector<bool>(open.graph.size(), false)};
  if (!sea.domain().ice()) {
    result.reaches_goal = true;
    return result;
  }
  const Spans spans{sea, grid, depart, longest_s};
  const std::size_t last_span = last_of_use(spans, grid, longest_s, stop);
  const std::vector<double> earliest_s = earliest_arrivals(grid, stop);
  std::vector<std::vector<double>> to_openings_s(spans.count());
  std::vector<std::vector<Vertex>> surfacings(spans.count());
  for (std::size_t span = 0; span <= last_span && !stop.stop_requested(); ++span) {
    for (std::size_t later = span; later <= spans.last_after(span); ++later) {
      if (to_openings_s[later].empty()) to_openings_s[later] = spans.to_openings_s(later);
    }
    // Time at each vertex since a surfacing within this span, in seconds.
    std::vector<double> since_s(open.graph.size(), never_s);
    for (const Vertex v : surfacings[span]) since_s[v] = 0.0;
    if (span == 0) since_s[open.grid.start] = std::min(since_s[open.grid.start], since_surfacing.count());
    const std::vector<double>& near_s = to_openings_s[span];
    const double surfaced_s = span == 0 ? -since_surfacing.count() : spans.begins_s(span);
    const auto there_s = [&](Vertex v, double time_s) {
      return std::max(earliest_s[v], surfaced_s + time_s);
    };
    lower_times(since_s, longest_s, stop, [&](Vertex v, double time_s, const auto& visit) {
      grid.for_each_edge_from(v, [&](const Edge& edge, double edge_s) {
        const bool surfaces = near_s[v] <= grid.straight_s(edge) && time_s + near_s[v] <= longest_s &&
                              there_s(v, time_s) <= spans.ends_s(span);
        visit(edge.head, surfaces ? std::min(time_s + edge_s, near_s[edge.head]) : time_s + edge_s);
      });
    });
    for (Vertex v = 0; v < open.graph.size(); ++v) {
      if (since_s[v] > longest_s) continue;
      result.reached[v] = true;
      for (std::size_t later = span + 1; later <= spans.last_after(span); ++later) {
        const double to_opening_s = to_openings_s[later][v];
        if (there_s(v, since_s[v]) > spans.ends_s(later) || to_opening_s > grid.longest_straight_s())
          continue;
        if (since_s[v] + to_opening_s <= longest_s) surfacings[later].push_back(v);
      }
    }
    if (result.reached[open.grid.goal]) {
      result.reaches_goal = true;
      return result;
    }
    to_openings_s[span].clear();
    surfacings[span].clear();
  }
  if (last_span + 1 < spans.count()) result.reached.assign(open.graph.size(), true);
  return result;
}

}  // namespace floeplan::planning::search

#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <stop_token>
#include <vector>

#include "engine/graph/arrival_queue.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/currents/current_envelope.hpp"
#include "engine/planning/search/grid/open_grid.hpp"

namespace floeplan::planning::search {

/// The time of a vertex that cannot be reached.
inline constexpr double never_s = std::numeric_limits<double>::infinity();

/// Lower bounds of the times of a grid's edges, valid at any time. They assume the fastest propulsion, and
/// from astern the strongest current near each edge.
/// Threads  const members may be called from several threads at once
class FavourableGrid {
 public:
  /// `sea` and `open` are borrowed and must outlive this object.
  FavourableGrid(const cost::Sea& sea, const OpenGrid& open);

  [[nodiscard]] const OpenGrid& open() const { return open_; }
  /// Least time of the edge in seconds, with the strongest current of the whole area from astern.
  [[nodiscard]] double straight_s(const graph::Edge& edge) const {
    return steps_[edge.step].least_time.count();
  }
  /// Least time of the grid's longest edges in seconds, with the strongest current of the whole area from
  /// astern.
  [[nodiscard]] double longest_straight_s() const { return longest_.least_time.count(); }

  /// Calls visit(edge, least time in seconds) for each edge out of a vertex.
  template <class Visit>
  void for_each_edge_from(graph::Vertex tail, const Visit& visit) const {
    const auto box = box_about(tail);
    open_.graph.for_each_edge(
        tail, [&](const graph::Edge& edge) { visit(edge, least_time_s(box, steps_[edge.step])); });
  }
  /// Calls visit(edge, least time in seconds) for each edge into a vertex.
  template <class Visit>
  void for_each_edge_to(graph::Vertex head, const Visit& visit) const {
    open_.graph.for_each_edge(head, [&](const graph::Edge& back) {
      // The steps go round the compass, so the opposite direction is half of the steps away.
      const auto step = static_cast<std::uint8_t>((back.step + steps_.size() / 2) % steps_.size());
      visit(graph::Edge{back.head, head, step}, least_time_s(box_about(back.head), steps_[step]));
    });
  }

 private:
  struct Step {
    core::Metres length;  // in the plane
    geo::PlanePoint direction;
    core::Seconds least_time;  // with the strongest current anywhere astern
  };
  [[nodiscard]] static std::vector<Step> steps_of(const cost::Sea& sea, const OpenGrid& open);
  [[nodiscard]] std::optional<currents::CurrentEnvelope::Box> box_about(graph::Vertex v) const {
    if (!envelope_) return std::nullopt;
    return envelope_->about(open_.grid.point(v));
  }
  [[nodiscard]] double least_time_s(const std::optional<currents::CurrentEnvelope::Box>& box,
                                    const Step& step) const {
    if (!box) return step.least_time.count();
    return sea_.least_time(step.length, box->most_along(step.direction)).count();
  }

  const cost::Sea& sea_;
  const OpenGrid& open_;
  std::vector<Step> steps_;
  Step longest_;
  std::optional<currents::CurrentEnvelope> envelope_;  // empty: still water
};

/// Lowers the time of each vertex to the best time through a neighbour, until no time falls any more
/// (Dijkstra). for_each_next(vertex, time_s, visit) calls visit(next, time at next in seconds) for each
/// neighbour of a vertex.
/// Stops  early once `stop` is requested; the times must then not be used
template <class ForEachNext>
void lower_times(std::vector<double>& times_s, double latest_s, const std::stop_token& stop,
                 const ForEachNext& for_each_next) {
  constexpr std::size_t vertices_between_looks = 1024;  // between checks of `stop`; each takes microseconds
  graph::ArrivalQueue queue{times_s.size()};
  for (graph::Vertex v = 0; v < times_s.size(); ++v) {
    if (times_s[v] <= latest_s) queue.insert(v, times_s[v]);
  }
  for (std::size_t done = 0; !queue.empty(); ++done) {
    if (done % vertices_between_looks == 0 && stop.stop_requested()) return;
    const graph::Vertex from = queue.extract_min();
    for_each_next(from, times_s[from], [&](graph::Vertex to, double time_s) {
      if (time_s >= times_s[to] || time_s > latest_s) return;
      times_s[to] = time_s;
      if (queue.holds(to)) {
        queue.decrease_key(to, time_s);
      } else {
        queue.insert(to, time_s);
      }
    });
  }
}

}  // namespace floeplan::planning::search

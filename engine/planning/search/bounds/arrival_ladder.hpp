#pragma once

#include <cstddef>
#include <stop_token>
#include <vector>

#include "engine/planning/search/bounds/foresight.hpp"

namespace floeplan::planning::search {

/// Bounds on when a vehicle that left the start at a given time is at the goal, by where it is and when: for one
/// arrival after the other, the rungs, a sweep of the foresight tells until when each vertex is of use, and who is
/// there later is not at the goal by then. So the bound knows the hour, where a bound on the rest of the way alone
/// would have to hold in every current to come.
/// Law      never later than the arrival of any way of open legs; later at a place, never an earlier bound
/// Threads  one at a time
class ArrivalLadder {
 public:
  /// `foresight` is borrowed and outlives the ladder; precondition: it is useful. `last`: an arrival after which
  /// nothing is of use. Once `stop` is requested the ladder stays incomplete and must not be used.
  /// `closures`: of the grid's vertices. `rungs`: at most so many, a sweep each; with one alone the ladder tells until
  /// when a vertex is of use, and little else.
  ArrivalLadder(Foresight& foresight, VertexClosures& closures, const OpenGrid& open, core::Seconds depart,
                core::Seconds last, const std::stop_token& stop, std::size_t rungs = most_rungs);

  static constexpr std::size_t most_rungs = 24;

  /// Whether some way may be at the goal by the last arrival.
  [[nodiscard]] bool has_hope() const { return has_hope_; }
  /// The earliest arrival at the goal for who is at the vertex then; infinite when it is after the last.
  [[nodiscard]] double earliest_s(graph::Vertex v, double t_s) const;
  /// Until when the vertex is of use; minus infinity: never.
  [[nodiscard]] double latest_use_s(graph::Vertex v) const { return until_s_[(v + 1) * rungs_s_.size() - 1]; }
  /// Never more than the time of an edge for who leaves its tail then.
  [[nodiscard]] double least_time_s(const graph::Edge& edge, double depart_s) {
    return foresight_.least_time(edge, core::Seconds{depart_s}).count();
  }

 private:
  Foresight& foresight_;
  bool has_hope_{false};
  double base_s_;                // no way is at the goal before
  std::vector<double> rungs_s_;  // ascending
  std::vector<double> until_s_;  // [vertex][rung]: until when it is of use
};

}  // namespace floeplan::planning::search

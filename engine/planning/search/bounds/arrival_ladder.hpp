#pragma once

#include <cstddef>
#include <stop_token>
#include <vector>

#include "engine/planning/search/bounds/foresight.hpp"

namespace floeplan::planning::search {

/// Lower bounds of the arrival at the goal, for a vehicle at a given vertex and time. A rung is a trial
/// arrival. For each rung a search backwards from the goal (`Foresight::sweep_back`) gives the latest useful
/// time at each vertex: a vehicle that is there later arrives after that rung. So the bound depends on the
/// time. A bound that ignores the time would have to hold for every later current, and would be lower.
/// Law      never later than the arrival of any route of open legs; a later time at a vertex never gives an
///          earlier bound
/// Threads  one at a time
class ArrivalLadder {
 public:
  /// `foresight` is borrowed and must outlive the ladder; precondition: `foresight.is_useful()`. `last`:
  /// later arrivals are of no use. `rungs`: their largest number. Each rung costs one backward search; a single
  /// rung gives only the latest useful time of each vertex.
  /// Once `stop` is requested the ladder stays incomplete and must not be used.
  ArrivalLadder(Foresight& foresight, const OpenGrid& open, core::Seconds depart, core::Seconds last,
                const std::stop_token& stop, std::size_t rungs = most_rungs);

  static constexpr std::size_t most_rungs = 24;

  /// Whether some route may reach the goal by the last arrival.
  [[nodiscard]] bool has_hope() const { return has_hope_; }
  /// Lower bound in seconds of the arrival at the goal of a vehicle at the vertex at `t_s`; infinite if after
  /// the last.
  [[nodiscard]] double earliest_s(graph::Vertex v, double t_s) const;
  /// The latest time, in seconds, at which a vehicle at the vertex can still arrive by the last rung;
  /// -infinity: never.
  [[nodiscard]] double latest_use_s(graph::Vertex v) const { return until_s_[(v + 1) * rungs_s_.size() - 1]; }
  /// Lower bound in seconds of the travel time of an edge for a departure from its tail at `depart_s`.
  [[nodiscard]] double least_time_s(const graph::Edge& edge, double depart_s) {
    return foresight_.least_time(edge, core::Seconds{depart_s}).count();
  }

 private:
  Foresight& foresight_;
  bool has_hope_{false};
  double base_s_;                // no route reaches the goal earlier
  std::vector<double> rungs_s_;  // ascending
  std::vector<double> until_s_;  // [vertex][rung]: the latest useful time
};

}  // namespace floeplan::planning::search

#pragma once

#include <cstddef>
#include <stop_token>
#include <vector>

#include "engine/planning/search/bounds/foresight.hpp"

namespace floeplan::planning::search {

/// Lower bounds of the arrival at the goal, by the place of the vehicle and the time. A rung is a trial arrival. For each rung
/// a search backwards from the goal (`Foresight::sweep_back`) gives the latest useful time at each vertex: a vehicle that is
/// there later arrives after that rung. So the bound depends on the time. A bound of the rest of the route alone would have to hold for all later currents.
/// Law      never later than the arrival of any route of open legs; a later time at a place never gives an earlier bound
/// Threads  one at a time
class ArrivalLadder {
 public:
  /// `foresight` is borrowed and outlives the ladder; precondition: it is useful. `last`: later arrivals are of no use.
  /// `closures`: of the grid's vertices. `rungs`: their largest number, a sweep each; a single rung gives only the latest
  /// useful time of each vertex. Once `stop` is requested the ladder stays incomplete and must not be used.
  ArrivalLadder(Foresight& foresight, VertexClosures& closures, const OpenGrid& open, core::Seconds depart,
                core::Seconds last, const std::stop_token& stop, std::size_t rungs = most_rungs);

  static constexpr std::size_t most_rungs = 24;

  /// Whether some route may reach the goal by the last arrival.
  [[nodiscard]] bool has_hope() const { return has_hope_; }
  /// Lower bound of the arrival at the goal from the vertex at that time; infinite if it is after the last.
  [[nodiscard]] double earliest_s(graph::Vertex v, double t_s) const;
  /// The latest useful time at the vertex; minus infinity: never.
  [[nodiscard]] double latest_use_s(graph::Vertex v) const { return until_s_[(v + 1) * rungs_s_.size() - 1]; }
  /// Lower bound of the time of an edge for a departure from its tail at that time.
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

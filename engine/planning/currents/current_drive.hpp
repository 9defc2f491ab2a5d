#pragma once

#include <cmath>
#include <tl/expected.hpp>

#include "engine/motion/edge_time.hpp"
#include "engine/planning/currents/current_line.hpp"

namespace floeplan::planning::currents {

/// Accuracy of a drive through the currents: its step is no longer than a cell of the data, nor than the time
/// between two slices. Null: still water.
[[nodiscard]] inline motion::EdgeAccuracy drive_accuracy(const PlaneCurrents* currents,
                                                         double relative_tolerance) {
  motion::EdgeAccuracy accuracy{.relative_tolerance = relative_tolerance};
  if (currents == nullptr) return accuracy;
  accuracy.longest_step = currents->spacing();
  if (const auto time_step = currents->time_step()) accuracy.longest_duration = *time_step;
  return accuracy;
}

/// Travel time along an edge in the currents; null: still water. All travel times come from this integration.
/// `visit`  is called with each piece of the drive and may close the edge
/// Errors   as `motion::edge_time`; in still water only what `visit` returns
template <motion::EdgePieceVisitor VisitPiece = motion::VisitNoPiece>
[[nodiscard]] tl::expected<core::Seconds, motion::EdgeClosed> drive_time(
    const PlaneCurrents* currents, const motion::PlaneEdge& edge, core::Seconds depart,
    core::MetresPerSecond through_water, const motion::EdgeAccuracy& accuracy,
    core::Seconds latest = core::Seconds{INFINITY}, const VisitPiece& visit = {}) {
  if (currents != nullptr && currents->has_lines())
    return motion::edge_time(edge, depart, through_water, *currents, accuracy, latest, visit);
  if (currents != nullptr) {
    const auto point_by_point = [&](geo::PlanePoint point, core::Seconds time) {
      return (*currents)(point, time);
    };
    return motion::edge_time(edge, depart, through_water, point_by_point, accuracy, latest, visit);
  }
  const core::Seconds time = edge.ground_length / through_water;
  if (time.count() <= 0.0) return time;
  const double v_m_s = through_water.value;
  const motion::EdgePiece whole{depart.count(),           0.0,  v_m_s, (depart + time).count(),
                                edge.ground_length.value, v_m_s};
  if (const auto closed = visit(whole)) return tl::unexpected(*closed);
  return time;
}

}  // namespace floeplan::planning::currents

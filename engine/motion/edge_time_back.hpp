#pragma once

#include <cmath>
#include <optional>
#include <tl/expected.hpp>

#include "engine/motion/edge_time.hpp"

namespace floeplan::motion {

/// A current in reversed time: its value at the time -t is the value of `current` at t, with the opposite sign.
template <PlaneCurrent Current>
struct MirroredCurrent {
  const Current& current;

  std::optional<CurrentXy> operator()(geo::PlanePoint point, core::Seconds mirrored) const {
    const std::optional<CurrentXy> c = current(point, -mirrored);
    if (!c) return std::nullopt;
    return CurrentXy{-c->x_m_s, -c->y_m_s};
  }
};

/// Travel time along `edge` for a vehicle that must be at its end at `arrive`: it has to leave this much
/// earlier. In reversed time the vehicle drives from the end to the start. Its speed over ground is then
/// (-c).(-e) + sqrt(V^2 - (c.n)^2), the same as forwards. So the result is `edge_time` in the mirrored
/// current.
/// Law      the inverse of `edge_time` within its tolerance, while the edge stays passable
/// Errors   as `edge_time`; too_late as soon as the departure is certainly before `earliest`
template <PlaneCurrent Current>
tl::expected<core::Seconds, EdgeClosed> edge_time_back(const PlaneEdge& edge, core::Seconds arrive,
                                                       core::MetresPerSecond through_water,
                                                       const Current& current, const EdgeAccuracy& accuracy,
                                                       core::Seconds earliest = core::Seconds{-INFINITY}) {
  const PlaneEdge run_back{edge.to, edge.from, edge.ground_length};
  return edge_time(run_back, -arrive, through_water, MirroredCurrent<Current>{current}, accuracy, -earliest);
}

}  // namespace floeplan::motion

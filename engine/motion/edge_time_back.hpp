#pragma once

#include <cmath>
#include <optional>
#include <tl/expected.hpp>

#include "engine/motion/edge_time.hpp"

namespace floeplan::motion {

/// A current as a film run backwards shows it: at the time -t the water of the time t, flowing the other way.
template <PlaneCurrent Current>
struct MirroredCurrent {
  const Current& current;

  std::optional<CurrentXy> operator()(geo::PlanePoint point, core::Seconds mirrored) const {
    const std::optional<CurrentXy> c = current(point, -mirrored);
    if (!c) return std::nullopt;
    return CurrentXy{-c->x_m_s, -c->y_m_s};
  }
};

/// Travel time along `edge` for a vehicle that is to be at its end at `arrive`: it has to leave that much
/// earlier. On the film run backwards the vehicle drives from the end to the start; its speed over ground
/// there is (-c).(-e) + sqrt(V^2 - (c.n)^2), the same as forwards, so that this is `edge_time` in the
/// mirrored current.
/// Law      the inverse of `edge_time` within its tolerance, while the edge stays passable
/// Errors   as `edge_time`; too_late as soon as it is certain that the departure is before `earliest`
template <PlaneCurrent Current>
tl::expected<core::Seconds, EdgeClosed> edge_time_back(const PlaneEdge& edge, core::Seconds arrive,
                                                       core::MetresPerSecond through_water,
                                                       const Current& current, const EdgeAccuracy& accuracy,
                                                       core::Seconds earliest = core::Seconds{-INFINITY}) {
  const PlaneEdge run_back{edge.to, edge.from, edge.ground_length};
  return edge_time(run_back, -arrive, through_water, MirroredCurrent<Current>{current}, accuracy, -earliest);
}

}  // namespace floeplan::motion

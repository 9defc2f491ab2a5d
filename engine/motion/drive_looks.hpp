#pragma once

#include <algorithm>
#include <cmath>

#include "engine/motion/edge_time.hpp"

namespace floeplan::motion {

/// The place at this distance (on the ground) along the edge, at most the edge's end.
inline geo::PlanePoint place_along(const PlaneEdge& edge, double way_m) {
  const double along = std::min(way_m / edge.ground_length.value, 1.0);
  return {edge.from.x_m + along * (edge.to.x_m - edge.from.x_m),
          edge.from.y_m + along * (edge.to.y_m - edge.from.y_m)};
}

/// Samples a piece of a drive: calls `visit(point, time)` at least every `step` metres, and at the piece's
/// end, until it returns false. The piece's beginning is left out, because it is the end of the piece before.
template <class Visit>
void look_along(const PlaneEdge& edge, const EdgePiece& piece, core::Metres step, const Visit& visit) {
  const double gain = piece.way1_m - piece.way0_m;
  const double duration = piece.t1_s - piece.t0_s;
  const double v0 = piece.v0_m_s * duration;
  const double a = v0 + piece.v1_m_s * duration - 2.0 * gain;
  const double b = gain - v0 - a;
  const int looks = std::max(1, static_cast<int>(std::ceil(gain / step.value)));
  for (int look = 1; look <= looks; ++look) {
    const double share = static_cast<double>(look) / looks;
    const double way = piece.way0_m + share * (v0 + share * (b + share * a));
    if (!visit(place_along(edge, way), core::Seconds{piece.t0_s + share * duration})) return;
  }
}

}  // namespace floeplan::motion

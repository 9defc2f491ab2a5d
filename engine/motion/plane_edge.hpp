#pragma once

#include <cmath>

#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/motion/plane_current.hpp"

namespace floeplan::motion {

/// A straight line in the plane and its length on the ground.
struct PlaneEdge {
  geo::PlanePoint from;
  geo::PlanePoint to;
  core::Metres ground_length;
};

/// A current split into its components along the direction of an edge and across it.
struct CurrentOnEdge {
  double along_m_s{};
  double across_m_s{};
};

/// Unit vector of an edge's direction. Precondition: the edge has a length in the plane.
class EdgeDirection {
 public:
  explicit EdgeDirection(const PlaneEdge& edge) {
    const double dx = edge.to.x_m - edge.from.x_m;
    const double dy = edge.to.y_m - edge.from.y_m;
    const double length = std::sqrt(dx * dx + dy * dy);
    ex_ = dx / length;
    ey_ = dy / length;
  }

  [[nodiscard]] CurrentOnEdge operator()(CurrentXy c) const {
    return {c.x_m_s * ex_ + c.y_m_s * ey_, c.x_m_s * ey_ - c.y_m_s * ex_};
  }

 private:
  double ex_{};
  double ey_{};
};

}  // namespace floeplan::motion

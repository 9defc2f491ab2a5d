#pragma once

#include <cmath>
#include <optional>

#include "engine/core/units.hpp"
#include "engine/motion/plane_edge.hpp"

namespace floeplan::motion {

/// A vehicle whose speed over ground is below this share of its speed through water counts as standing still.
/// A judgement.
inline constexpr double least_progress = 0.01;

/// A vehicle that turns its nose into the current to stay on an edge. Its speed over ground is v = a +
/// sqrt(V^2 - n^2), where V is its speed through water, a the current along the edge and n the current
/// across. The edge is passable if |n| < V and v > v_min.
/// Source   Eichhorn 2009, section III.C
class Crabbing {
 public:
  explicit Crabbing(core::MetresPerSecond through_water)
      : v_{through_water.value}, v2_{v_ * v_}, v_min_{least_progress * v_} {}

  /// Seconds per metre over the ground; empty if the current is too strong.
  [[nodiscard]] std::optional<double> slowness(CurrentOnEdge c) const {
    const double margin = v2_ - c.across_m_s * c.across_m_s;
    if (!(margin > 0.0)) return std::nullopt;
    const double v = c.along_m_s + std::sqrt(margin);
    if (!(v > v_min_)) return std::nullopt;
    return 1.0 / v;
  }

  /// Largest change of the current, in any direction, that cannot close the edge; not positive if the edge is
  /// closed. In the plane of (a, n) the passable currents fill the strip |n| < V to the right of the
  /// left half of the circle of radius V around (v_min, 0). The result is the distance to the border of this area.
  [[nodiscard]] double room(CurrentOnEdge c) const {
    const double short_of = c.along_m_s - v_min_;
    const double across = std::abs(c.across_m_s);
    if (short_of >= 0.0) return v_ - across;
    return v_ - std::sqrt(short_of * short_of + across * across);
  }

 private:
  double v_;
  double v2_;
  double v_min_;
};

}  // namespace floeplan::motion

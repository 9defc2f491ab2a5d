#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/motion/crabbing.hpp"
#include "engine/motion/plane_edge.hpp"

namespace floeplan::motion {

/// A current on an edge that is quadratic in the distance: a bilinear grid cell along a line.
struct WayQuadratic {
  CurrentOnEdge constant;
  CurrentOnEdge linear;
  CurrentOnEdge square;

  [[nodiscard]] CurrentOnEdge at(double way_m) const { return between(way_m, way_m); }

  /// The value at `a` if a = b. For a < b the middle one of three values that bound the quadratic on [a, b];
  /// the outer two are those at a and at b (polar form).
  [[nodiscard]] CurrentOnEdge between(double a_m, double b_m) const {
    const double middle = 0.5 * (a_m + b_m);
    const double product = a_m * b_m;
    return {constant.along_m_s + middle * linear.along_m_s + product * square.along_m_s,
            constant.across_m_s + middle * linear.across_m_s + product * square.across_m_s};
  }
};

/// The current on a stretch of an edge within one grid cell and one time step.
/// Frame    distance in metres on the ground from the edge's start; seconds on the clock of the departure
struct QuadraticStretch {
  static constexpr bool is_bounded = true;

  WayQuadratic at_start;    // at the time start_s
  WayQuadratic per_second;  // change per second
  double start_s{};
  double end_way_m{std::numeric_limits<double>::infinity()};
  double end_s{std::numeric_limits<double>::infinity()};

  /// Continues smoothly beyond both ends, so that a step may test points slightly ahead.
  [[nodiscard]] std::optional<CurrentOnEdge> at(double way_m, double t_s) const {
    const CurrentOnEdge start = at_start.at(way_m);
    const CurrentOnEdge change = per_second.at(way_m);
    const double since = t_s - start_s;
    return CurrentOnEdge{start.along_m_s + since * change.along_m_s,
                         start.across_m_s + since * change.across_m_s};
  }

  /// Lower bound of `Crabbing::room` for all distances and times in these ranges; exact if the current is
  /// constant.
  [[nodiscard]] double least_room(const Crabbing& crabbing, double way0_m, double t0_s, double way1_m,
                                  double t1_s) const {
    const double since0 = t0_s - start_s;
    const double since1 = t1_s - start_s;
    CurrentOnEdge worst{std::numeric_limits<double>::infinity(), 0.0};
    const auto include = [&](double a_m, double b_m) {
      const CurrentOnEdge start = at_start.between(a_m, b_m);
      const CurrentOnEdge change = per_second.between(a_m, b_m);
      worst.along_m_s = std::min({worst.along_m_s, start.along_m_s + since0 * change.along_m_s,
                                  start.along_m_s + since1 * change.along_m_s});
      worst.across_m_s = std::max({worst.across_m_s, std::abs(start.across_m_s + since0 * change.across_m_s),
                                   std::abs(start.across_m_s + since1 * change.across_m_s)});
    };
    include(way0_m, way0_m);
    include(way0_m, way1_m);
    include(way1_m, way1_m);
    return crabbing.room(worst);
  }
};

}  // namespace floeplan::motion

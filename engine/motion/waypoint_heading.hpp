#pragma once

#include <cmath>
#include <optional>

namespace floeplan::motion {

/// Where a Slocum points its nose to come to a place: along the course at its speed through the water, less the current
/// that it reckons with. It so comes to the place from downstream, also where no heading would hold the course.
/// Frame    any of the level with two axes; the heading is in radians, clockwise from the second
/// Units    m and m/s, of the place as seen from the vehicle and of the current
/// Edges    empty at the place itself
/// Source   the log of comet of 21 August 2019
[[nodiscard]] inline std::optional<double> waypoint_heading(double east_m, double north_m, double speed_m_s,
                                                            double current_east_m_s,
                                                            double current_north_m_s) {
  const double gap_m = std::hypot(east_m, north_m);
  if (gap_m == 0.0) return std::nullopt;
  return std::atan2(speed_m_s * east_m / gap_m - current_east_m_s,
                    speed_m_s * north_m / gap_m - current_north_m_s);
}

}  // namespace floeplan::motion

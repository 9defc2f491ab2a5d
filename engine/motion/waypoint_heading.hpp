#pragma once

#include <cmath>
#include <optional>

namespace floeplan::motion {

/// The heading of a Slocum towards a place: the vector of its speed through water along the course, minus the
/// current that it assumes. So it approaches the place from downstream, even if no heading would hold the
/// course.
/// Frame    any horizontal frame with two axes; the heading is in radians, clockwise from the second axis
/// Units    m and m/s; the place is relative to the vehicle
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

#pragma once

#include <algorithm>
#include <cmath>

#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/geo/velocity.hpp"

namespace floeplan::avoidance {

/// Direction from one place to another, clockwise from north.
[[nodiscard]] inline double direction_rad(geo::PlanePoint from, geo::PlanePoint to) {
  return std::atan2(to.x_m - from.x_m, to.y_m - from.y_m);
}

[[nodiscard]] inline geo::PlanePoint moved(geo::PlanePoint from, double heading_rad, double way_m) {
  return {from.x_m + way_m * std::sin(heading_rad), from.y_m + way_m * std::cos(heading_rad)};
}

/// Heading that holds a course in a current, and the resulting speed.
struct Crab {
  double heading_rad{};
  double speed_m_s{};  // over ground along the course; negative: the current sets the vehicle back
};

/// If the current across the course exceeds the vehicle's speed, the nose points straight against it.
/// Source   navigation triangle, as in engine/motion/crabbing.hpp
[[nodiscard]] inline Crab crab(double course_rad, geo::VelocityEn current, double through_water_m_s) {
  const double east = std::sin(course_rad);
  const double north = std::cos(course_rad);
  const double along = current.east.value * east + current.north.value * north;
  const double to_starboard = current.east.value * north - current.north.value * east;
  const double correction = std::asin(std::clamp(-to_starboard / through_water_m_s, -1.0, 1.0));
  return {course_rad + correction, along + through_water_m_s * std::cos(correction)};
}

}  // namespace floeplan::avoidance

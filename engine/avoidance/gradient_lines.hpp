#pragma once

#include <cstdint>
#include <span>

#include "engine/avoidance/obstacles.hpp"
#include "engine/avoidance/settings.hpp"
#include "engine/geo/local_projection.hpp"

namespace floeplan::avoidance {

/// A heading to steer and how it was come by.
struct GradientCourse {
  double heading_rad{};
  bool boxed_in{};  // every heading leads to contact; this one has the latest
};

/// Real-time course commands around near objects.
///
/// From every place a gradient line leads to the goal: straight if that is free, otherwise along the tangent
/// to the obstacles in the way, on one side of them, and straight again once they are passed. It is
/// constructed in the water frame, where a steady heading is a straight line. Headings are tested from the
/// goal's heading away to the chosen side; the first that touches no moving disc within the horizon is the
/// tangent. The side is kept until the way to the goal is free, so that the vehicle goes round and not to and
/// fro.
/// No local minimum: following a line round an obstacle ends only where the goal can be steered for. This
/// holds for every body, convex or not, if its hollows are shorter than the look ahead (`watch` times the
/// speed, 315 m)
/// Memory   fixed; no member allocates
/// Source   after the gradient lines of Eichhorn 2005, A reactive obstacle avoidance system for an autonomous
///          underwater vehicle, IFAC World Congress; the side held as in Kamon, Rivlin and Rimon 1996, A new
///          range-sensor based globally convergent navigation algorithm for mobile robots, ICRA (TangentBug)
class GradientLines {
 public:
  explicit GradientLines(const AvoidanceSettings& settings) : settings_{settings} {}

  /// `goal_heading_rad` leads to the goal in still and empty water; `goal_s` is how long that takes.
  [[nodiscard]] GradientCourse steer(geo::PlanePoint own_in_water, double through_water_m_s,
                                     double goal_heading_rad, double goal_s,
                                     std::span<const Obstacle> obstacles);
  /// Forgets the chosen side: the obstacle is passed.
  void release() { side_ = 0; }
  [[nodiscard]] int side() const { return side_; }  // 1: starboard, -1: port, 0: none chosen

 private:
  AvoidanceSettings settings_;
  int side_{};
};

}  // namespace floeplan::avoidance

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
  bool boxed_in{};  // every heading ends in contact: this is the one with the latest
};

/// Course commands in real time around what is near.
///
/// From every place a gradient line leads to the goal: straight where that is free, else along the tangent to the
/// obstacles in the way, on one side of them, and straight again from where they are passed. It is constructed in the
/// water frame, where the vehicle's way is a straight line for any steady heading: headings are swept from the goal's
/// away to the side that was taken up, and the first that touches no moving disc within the horizon is the tangent. The
/// side holds until the way to the goal is free again, so that the vehicle goes round and not to and fro.
/// No local minimum: a line that is followed round an obstacle ends only where the goal can be steered for, for every
/// body, convex or not, whose hollow is shorter than the way that is looked ahead (`watch` times the speed, 315 m)
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
  /// Forgets the side: what was gone round is passed.
  void release() { side_ = 0; }
  [[nodiscard]] int side() const { return side_; }  // 1 starboard, -1 port, 0 none taken up

 private:
  AvoidanceSettings settings_;
  int side_{};
};

}  // namespace floeplan::avoidance

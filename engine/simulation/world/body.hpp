#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/simulation/world/convex_part.hpp"
#include "engine/simulation/world/space.hpp"

namespace floeplan::simulation {

/// Shape of a body below the water: the union of its convex parts, so hollows and overhangs are possible.
struct Shape {
  std::vector<ConvexPart> parts;
  double radius_m{};  // of a vertical cylinder around the axis that contains all of it
  double draft_m{};   // depth of its deepest point
};

/// Place and orientation of a body at a time, computed once for many queries.
struct BodyPose {
  double east_m{};
  double north_m{};
  double sine{};  // of the heading of its length, clockwise from the plane's north
  double cosine{1.0};
};

/// Where a ray meets a body.
struct BodyHit {
  double range_m{};
  Vector normal{};  // outward, of unit length
};

/// A rigid body that drifts and rotates: an iceberg, a rock, an obstacle of a test.
/// Motion   straight at constant speed between the fixes of its track, at rest before the first and after the
///          last; constant rotation
/// Threads  const members may be called from several threads at once
class Body {
 public:
  struct Fix {
    core::UtcTime time{};
    double east_m{};
    double north_m{};
  };
  struct Motion {
    std::vector<Fix> track;  // one fix or more, by time
    double heading_rad{};    // of its length at the first fix, clockwise from the plane's north
    double spin_rad_s{};     // clockwise
  };

  /// Errors   std::invalid_argument for a shape without parts, an empty track and times that are not
  ///          ascending
  Body(std::string name, Shape shape, Motion motion);

  [[nodiscard]] BodyPose pose_at(core::UtcTime time) const;
  /// Velocity of the drift over ground; m/s east and north.
  [[nodiscard]] Vector velocity_at(core::UtcTime time) const;

  [[nodiscard]] bool contains(const BodyPose& pose, Vector point) const;
  /// Lower bound of the distance from a point to the body, computed quickly; zero or negative inside.
  [[nodiscard]] double least_distance(const BodyPose& pose, Vector point) const;
  /// Distance from a point to the body, to a centimetre; zero or negative inside.
  [[nodiscard]] double distance(const BodyPose& pose, Vector point) const;
  /// Where the ray from `origin` along the unit vector `direction` first meets the body within `max_range_m`.
  [[nodiscard]] std::optional<BodyHit> first_hit(const BodyPose& pose, Vector origin, Vector direction,
                                                 double max_range_m) const;

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const Shape& shape() const { return shape_; }
  [[nodiscard]] const Motion& motion() const { return motion_; }

 private:
  std::string name_;
  Shape shape_;
  Motion motion_;
};

}  // namespace floeplan::simulation

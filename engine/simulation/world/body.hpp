#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/simulation/world/convex_part.hpp"
#include "engine/simulation/world/space.hpp"

namespace floeplan::simulation {

/// Form of a body below the water: the union of its parts, which makes hollows and overhangs.
struct Shape {
  std::vector<ConvexPart> parts;
  double radius_m{};  // of a vertical cylinder about the axis that holds all of it
  double draft_m{};   // depth of its deepest point
};

/// Where a body is at a time: what its questions are asked with, reckoned once for many of them.
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

/// A rigid body that drifts and turns: an iceberg, a rock, a trap of a test.
/// Motion   straight and even between the fixes of its track, at rest before the first and after the last; it turns
///          evenly
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

  /// Errors   std::invalid_argument for a shape without parts, an empty track and times that do not ascend
  Body(std::string name, Shape shape, Motion motion);

  [[nodiscard]] BodyPose pose_at(core::UtcTime time) const;
  /// Velocity of the drift over ground; m/s east and north.
  [[nodiscard]] Vector velocity_at(core::UtcTime time) const;

  [[nodiscard]] bool contains(const BodyPose& pose, Vector point) const;
  /// Never more than the distance from a point to the body, and quick; not positive inside.
  [[nodiscard]] double least_distance(const BodyPose& pose, Vector point) const;
  /// Distance from a point to the body, to a centimetre; not positive inside.
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

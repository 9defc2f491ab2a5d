#pragma once

#include <optional>
#include <vector>

namespace floeplan::simulation {

/// A place or direction in a body's own axes: along its length, across to the right, down; metres.
struct BodyPoint {
  double along{};
  double across{};
  double down{};

  friend bool operator==(const BodyPoint&, const BodyPoint&) = default;
};

/// Where a ray meets a surface.
struct PartHit {
  double range_m{};
  BodyPoint normal{};  // outward, of unit length
};

/// A convex solid bounded by planes; bodies consist of such parts.
/// Threads  const members may be called from several threads at once
class ConvexPart {
 public:
  /// The half space normal . point <= offset_m.
  struct Face {
    BodyPoint normal{};  // outward, of unit length
    double offset_m{};
  };

  /// Errors   std::invalid_argument for fewer than four faces or a normal that is not of unit length
  explicit ConvexPart(std::vector<Face> faces);

  [[nodiscard]] bool contains(BodyPoint point) const { return plane_distance(point) <= 0.0; }
  /// Lower bound of the distance to the surface, computed quickly. Inside it is minus the distance.
  [[nodiscard]] double plane_distance(BodyPoint point) const;
  /// Distance to the surface, to a centimetre; inside as `plane_distance`.
  /// Source   Hildreth 1957, A quadratic programming procedure, Nav. Res. Logist. Q. 4
  [[nodiscard]] double distance(BodyPoint point) const;
  /// Where the ray from `origin` along the unit vector `direction` enters; range 0 if it starts inside.
  [[nodiscard]] std::optional<PartHit> first_hit(BodyPoint origin, BodyPoint direction,
                                                 double max_range_m) const;
  [[nodiscard]] const std::vector<Face>& faces() const { return faces_; }

 private:
  std::vector<Face> faces_;
};

}  // namespace floeplan::simulation

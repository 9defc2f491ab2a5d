#pragma once

#include <string_view>

namespace floeplan::geo {

/// A horizontal direction, clockwise from true north. Stored as a unit vector, so angles do not wrap around.
class Bearing {
 public:
  [[nodiscard]] static Bearing degrees(double clockwise_from_north_deg);
  /// Direction of the vector (east, north); north if both are zero.
  [[nodiscard]] static Bearing towards(double east, double north);

  [[nodiscard]] double east() const { return east_; }
  [[nodiscard]] double north() const { return north_; }
  /// The bearing in degrees, in [0, 360).
  [[nodiscard]] double degrees() const;

 private:
  Bearing(double east, double north) : east_{east}, north_{north} {}

  double east_;
  double north_;
};

/// The nearest of the eight points of the compass in words: "north-east".
[[nodiscard]] std::string_view compass_point(Bearing bearing);

}  // namespace floeplan::geo

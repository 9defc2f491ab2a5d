#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace floeplan::ingest {

/// The direction of a grid's first axis at every point: cosine and sine of its angle, counterclockwise from east. The
/// second axis lies a quarter turn counterclockwise from the first.
struct GridDirections {
  std::vector<float> cosine;
  std::vector<float> sine;

  /// Directions of a grid whose first axis points east at each of its points.
  [[nodiscard]] static GridDirections along_east(std::size_t points);
  /// Adds the angle of the next point, in radians; an unknown angle (empty) counts as east.
  void add(std::optional<double> angle);
  void set(std::size_t point, double angle);
  /// The largest angle between the grid's first axis and east, degrees.
  [[nodiscard]] double largest_turn_deg() const;
};

/// Components towards true east and true north, m/s.
struct EastNorth {
  float east{};
  float north{};
};

/// Rotates components along the axes of a grid to true east and true north. No other code does this.
/// Accuracy  single precision; NaN if a component is NaN
[[nodiscard]] inline EastNorth to_true_north(double along_first, double along_second,
                                             const GridDirections& directions, std::size_t point) {
  const auto cosine = static_cast<double>(directions.cosine[point]);
  const auto sine = static_cast<double>(directions.sine[point]);
  return {static_cast<float>(along_first * cosine - along_second * sine),
          static_cast<float>(along_first * sine + along_second * cosine)};
}

}  // namespace floeplan::ingest

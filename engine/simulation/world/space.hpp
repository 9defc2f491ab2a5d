#pragma once

#include <cmath>

namespace floeplan::simulation {

/// A place or a direction in the frame of a flight.
/// Frame    metres of the local plane east and north of the flight's origin, and metres down from the surface
struct Vector {
  double east{};
  double north{};
  double down{};

  friend constexpr Vector operator+(Vector a, Vector b) {
    return {a.east + b.east, a.north + b.north, a.down + b.down};
  }
  friend constexpr Vector operator-(Vector a, Vector b) {
    return {a.east - b.east, a.north - b.north, a.down - b.down};
  }
  friend constexpr Vector operator*(double factor, Vector a) {
    return {factor * a.east, factor * a.north, factor * a.down};
  }
  friend bool operator==(const Vector&, const Vector&) = default;
};

[[nodiscard]] constexpr double dot(Vector a, Vector b) {
  return a.east * b.east + a.north * b.north + a.down * b.down;
}
[[nodiscard]] inline double length(Vector a) { return std::sqrt(dot(a, a)); }

}  // namespace floeplan::simulation

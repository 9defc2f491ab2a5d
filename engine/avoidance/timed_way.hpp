#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "engine/geo/local_projection.hpp"

namespace floeplan::avoidance {

/// A place and the time to be there, in seconds on the clock of the flight.
struct TimedPoint {
  geo::PlanePoint place{};
  double time_s{};

  friend bool operator==(const TimedPoint&, const TimedPoint&) = default;
};

/// Straight moves at constant speed from point to point. Frame: water, where a steady heading is a straight
/// line.
/// Memory   fixed
class TimedWay {
 public:
  static constexpr std::size_t most_points = 128;

  /// Adds a point. Beyond `most_points` it is left out, so the way ends earlier.
  void add(const TimedPoint& point) {
    if (size_ < most_points) points_[size_++] = point;
  }
  [[nodiscard]] std::span<const TimedPoint> points() const { return {points_.data(), size_}; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] bool is_full() const { return size_ == most_points; }

 private:
  std::array<TimedPoint, most_points> points_{};
  std::size_t size_{};
};

}  // namespace floeplan::avoidance

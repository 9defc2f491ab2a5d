#pragma once

#include "engine/core/units.hpp"
#include "engine/simulation/world/space.hpp"

namespace floeplan::simulation {

/// Attitude of the vehicle.
/// Frame    heading clockwise from the plane's north, pitch positive nose up, roll positive starboard down;
///          radians
struct Attitude {
  double heading_rad{};
  double pitch_rad{};
  double roll_rad{};

  friend bool operator==(const Attitude&, const Attitude&) = default;
};

/// True place and motion of the vehicle. Models of sensors use it; the vehicle's computer never sees it.
struct TrueState {
  core::UtcTime time{};
  Vector position{};  // metres
  Attitude attitude{};
  Vector through_water{};  // velocity, m/s
  Vector over_ground{};    // velocity, m/s: through_water plus the current

  friend bool operator==(const TrueState&, const TrueState&) = default;
};

/// Rotates vectors between the vehicle's axes and those of the flight: heading, then pitch, then roll.
class BodyAxes {
 public:
  explicit BodyAxes(const Attitude& attitude);

  /// Converts a vector given as forward, starboard and down along the hull.
  [[nodiscard]] Vector to_frame(double forward, double starboard, double down) const {
    return forward * forward_ + starboard * starboard_ + down * down_;
  }
  [[nodiscard]] Vector forward() const { return forward_; }
  [[nodiscard]] Vector starboard() const { return starboard_; }
  [[nodiscard]] Vector down() const { return down_; }

 private:
  Vector forward_;
  Vector starboard_;
  Vector down_;
};

}  // namespace floeplan::simulation

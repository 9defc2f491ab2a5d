#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "engine/avoidance/sensed.hpp"

namespace floeplan::support {

/// The sensor values of a vehicle that goes east among walls on every side. Each ping has more echoes than a
/// sonar can give, and the walls have more surfaces than the map of objects can hold.
class CrowdedSea {
 public:
  explicit CrowdedSea(std::size_t echoes) : returns_(echoes), bins_(20) {}

  /// The same second gives the same values. The spans are valid until the next call.
  const avoidance::Sensed& at(double second) {
    const double place_m = 0.35 * second;
    sensed_.own.time = core::from_unix_seconds(1e9 + second);
    sensed_.own.place = {place_m, 0.0};
    sensed_.own.depth = core::Metres{20.0 + 10.0 * std::sin(second / 40.0)};
    sensed_.own.attitude.heading = core::Radians{std::numbers::pi / 2.0};
    sensed_.own.attitude.pitch = core::Radians{std::cos(second / 40.0) > 0.0 ? -0.45 : 0.45};
    sensed_.own.through_water = core::MetresPerSecond{0.35};
    sensed_.own.altitude = core::Metres{80.0};
    for (std::size_t i = 0; i < returns_.size(); ++i) returns_[i] = echo(i, place_m);
    for (std::size_t i = 0; i < bins_.size(); ++i) {
      bins_[i] = {core::Metres{5.0 * static_cast<double>(i)}, {{0.05}, {-0.02}}, core::MetresPerSecond{0.03}};
    }
    sensed_.sonar = avoidance::SonarPing{sensed_.own.time, returns_};
    sensed_.current = avoidance::CurrentProfile{sensed_.own.time, bins_};
    return sensed_;
  }

 private:
  /// Cliffs of ice 60 m before the vehicle's way every 90 m, in an echo from each of many bearings and depths.
  [[nodiscard]] avoidance::SonarReturn echo(std::size_t i, double place_m) const {
    const double share = static_cast<double>(i) / static_cast<double>(returns_.size());
    const double bearing = (share - 0.5) * 2.0 * std::numbers::pi;
    const double cliff_m = 90.0 * static_cast<double>(1 + i % 3) - std::fmod(place_m, 90.0);
    const double range_m = 20.0 + std::min(cliff_m, 175.0);
    const double elevation = 0.5 * (static_cast<double>(i % 5) / 2.0 - 1.0);
    return {core::Metres{range_m},
            {std::cos(elevation) * std::cos(bearing), std::cos(elevation) * std::sin(bearing),
             std::sin(elevation)},
            95.0};
  }

  std::vector<avoidance::SonarReturn> returns_;
  std::vector<avoidance::CurrentBin> bins_;
  avoidance::Sensed sensed_;
};

}  // namespace floeplan::support

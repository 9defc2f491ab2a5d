#pragma once

#include <cstdint>

#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"

namespace floeplan::avoidance {

/// How far and how well the sonar sees. Body axes.
struct SonarView {
  core::Metres reach{200.0};
  core::Radians tilt{0.0};              // of its middle above the plane of forward and starboard
  core::Radians half_height{0.6109};    // above and below its middle: 35 degrees
  core::Radians beam_half_height{0.0};  // of one beam: so far above or below its axis an echo may come from
  /// Beams whose axes are at least so far above or below the middle are the outermost. Beyond them none hears better,
  /// so that outwards their echoes may come from farther off their axes.
  core::Radians edge{0.6109};
  core::Radians edge_half_height{0.0};  // outwards, of the outermost beams; no less than `beam_half_height`
  core::Metres range_sigma{1.0};
  core::Radians bearing_sigma{0.0175};

  friend bool operator==(const SonarView&, const SonarView&) = default;
};

/// What a safety engineer may want to change. Defaults for a Slocum glider at 0.35 m/s with a 200 m sonar.
struct AvoidanceSettings {
  SonarView sonar{};
  core::MetresPerSecond through_water{0.35};  // horizontal, what paths are planned with
  core::Metres clearance{30.0};               // kept from the nearest known surface of an object
  core::Metres close{20.0};                   // nearer than that, reactive control steers
  core::Seconds watch{900.0};    // how far ahead the route is watched: the reach of the sonar at 0.22 m/s
  core::Seconds imminent{75.0};  // contact sooner than that on the course steered: reactive control
  core::Seconds settled{20.0};   // a more relaxed mode must have been possible for that long
  core::Seconds replan{15.0};    // least time between two plans
  core::Seconds forget{1200.0};  // a surface not seen for that long is dropped
  core::Seconds give_up{4.0 * 3600.0};        // of evading without coming nearer to the goal
  core::MetresPerSecond forecast_sigma{0.1};  // error of the carried forecast, rms of a component
  core::MetresPerSecond drift_sigma{0.1};     // of objects through the water, before any is measured
  core::Metres waypoint_radius{50.0};         // a waypoint counts as reached within it
  core::Metres shallowest{5.0};               // of the mission's saw-tooth
  core::Metres deepest{200.0};
  core::Metres vertical_margin{10.0};  // kept below ice and above the sea bed
  core::Metres least_band{15.0};       // a saw-tooth lower than that is not flown under ice
  core::Metres least_water{30.0};      // a bank shoaler than that is gone round
  std::int64_t most_expansions{4096};  // of one path search on the vehicle's computer

  [[nodiscard]] core::Violations violations() const;  // empty when valid, otherwise all of them
  friend bool operator==(const AvoidanceSettings&, const AvoidanceSettings&) = default;
};

}  // namespace floeplan::avoidance

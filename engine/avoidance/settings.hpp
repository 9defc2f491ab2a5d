#pragma once

#include <cstdint>

#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"

namespace floeplan::avoidance {

/// Field of view of the sonar. Body axes.
struct SonarView {
  core::Metres reach{200.0};
  core::Radians tilt{0.0};              // of the middle of the view above the plane of forward and starboard
  core::Radians half_height{0.6109};    // half of the view's height: 35 degrees
  core::Radians beam_half_height{0.0};  // of one beam: an echo may come from this far above or below its axis
  /// Beams whose axes are at least this far above or below the middle are the outermost. No further beam
  /// hears echoes beyond them better, so their echoes may come from farther outwards.
  core::Radians edge{0.6109};
  core::Radians edge_half_height{0.0};  // outwards, for the outermost beams; at least `beam_half_height`
  core::Metres range_sigma{1.0};
  core::Radians bearing_sigma{0.0175};

  friend bool operator==(const SonarView&, const SonarView&) = default;
};

/// Settings that a safety engineer may change. Defaults for a Slocum glider at 0.35 m/s with a 200 m sonar.
struct AvoidanceSettings {
  SonarView sonar{};
  core::MetresPerSecond through_water{0.35};  // horizontal speed for path planning
  core::Metres clearance{30.0};               // kept from the nearest known surface of an object
  core::Metres close{20.0};                   // reactive control steers if something is nearer
  core::Seconds watch{900.0};           // how far ahead the route is checked: the sonar's reach at 0.22 m/s
  core::Seconds imminent{75.0};         // reactive control steers if the course leads to contact sooner
  core::Seconds settled{20.0};          // a calmer mode must have been possible for this time
  core::Seconds replan{15.0};           // least time between two path searches
  core::Seconds forget{1200.0};         // a surface not seen for this time is dropped
  core::Seconds give_up{4.0 * 3600.0};  // time of evasion without getting nearer to the goal
  core::MetresPerSecond forecast_sigma{0.1};  // error of the carried forecast, rms per component
  core::MetresPerSecond drift_sigma{0.1};     // drift of objects through water before it is measured
  core::Metres waypoint_radius{50.0};         // within which a waypoint counts as reached
  core::Metres shallowest{5.0};               // upper turn of the mission's saw-tooth
  core::Metres deepest{200.0};
  core::Metres vertical_margin{10.0};  // kept below ice and above the sea bed
  core::Metres least_band{15.0};       // least height of a saw-tooth under ice
  core::Metres least_water{30.0};      // shallower banks are avoided
  std::int64_t most_expansions{4096};  // limit of one path search on the vehicle's computer

  [[nodiscard]] core::Violations violations() const;  // empty when valid, otherwise all of them
  friend bool operator==(const AvoidanceSettings&, const AvoidanceSettings&) = default;
};

}  // namespace floeplan::avoidance

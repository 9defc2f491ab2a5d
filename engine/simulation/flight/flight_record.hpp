#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/avoidance/guidance.hpp"
#include "engine/core/units.hpp"
#include "engine/geo/velocity.hpp"
#include "engine/simulation/vehicle/true_state.hpp"
#include "engine/simulation/world/space.hpp"

/// The result of one simulated flight. Places are in the frame of the flight's world; energy is counted from
/// the start.
namespace floeplan::simulation {

/// One time on the track.
struct TrackPoint {
  core::UtcTime time{};
  Vector position{};     // true place of the vehicle
  Vector believed{};     // place by dead reckoning and depth sensor
  double sigma_m{};      // stated error of `believed`: one standard deviation of east and of north
  Attitude attitude{};   // true
  Vector over_ground{};  // true velocity, m/s
  core::Joules energy{};
  bool at_surface{};
  avoidance::Mode mode{avoidance::Mode::mission};

  friend bool operator==(const TrackPoint&, const TrackPoint&) = default;
};

enum class EventKind : std::uint8_t {
  departure,
  dive,  // leaves the surface
  inflection,
  surfacing,
  fix,       // by GPS
  waypoint,  // reached, as the vehicle believes
  guidance,  // the onboard avoidance changes its mode
  contact,   // with a body, the sea bed or the ice
  end        // reason in FlightRecord::end
};

struct FlightEvent {
  core::UtcTime time{};
  EventKind kind{};
  Vector position{};
  std::string text;  // for a person; empty if the kind says all

  friend bool operator==(const FlightEvent&, const FlightEvent&) = default;
};

/// The closest approach of the vehicle to an object.
struct ClosestApproach {
  std::string to;  // "sea bed", "sea ice" or the name of a body
  double distance_m{};
  core::UtcTime time{};
  Vector position{};  // of the vehicle

  friend bool operator==(const ClosestApproach&, const ClosestApproach&) = default;
};

struct SonarEntry {  // a ping with at least one echo
  core::UtcTime time{};
  int returns{};
  double nearest_m{};

  friend bool operator==(const SonarEntry&, const SonarEntry&) = default;
};

struct AltimeterEntry {
  core::UtcTime time{};
  double altitude_m{};

  friend bool operator==(const AltimeterEntry&, const AltimeterEntry&) = default;
};

struct CurrentEntry {  // one depth bin of an ADCP profile
  core::UtcTime time{};
  double depth_m{};
  geo::VelocityEn measured{};
  core::MetresPerSecond one_sigma{};

  friend bool operator==(const CurrentEntry&, const CurrentEntry&) = default;
};

struct FixEntry {
  core::UtcTime time{};
  Vector fixed{};                    // place by GPS
  Vector believed{};                 // before the fix
  geo::VelocityEn depth_averaged{};  // mean current since the fix before, as the vehicle computes it

  friend bool operator==(const FixEntry&, const FixEntry&) = default;
};

/// Readings of the sensors, thinned on long flights.
struct SensorLog {
  std::vector<SonarEntry> sonar;
  std::vector<AltimeterEntry> altimeter;
  std::vector<CurrentEntry> currents;
  std::vector<FixEntry> fixes;

  friend bool operator==(const SensorLog&, const SensorLog&) = default;
};

enum class FlightEnd : std::uint8_t {
  arrived,    // the last waypoint was reached, and the vehicle surfaced there
  collided,   // with a body or the sea ice
  grounded,   // on the sea bed
  gave_up,    // ended by mission or onboard avoidance, or turned back at ice over the goal
  time_up,    // longer than allowed by the settings
  battery,    // below the reserve
  left_data,  // left the known part of the world
  stopped     // on request: the record is incomplete
};

[[nodiscard]] std::string_view text(EventKind kind);
[[nodiscard]] std::string_view text(FlightEnd end);

struct FlightRecord {
  std::uint64_t seed{};
  FlightEnd end{};
  std::string end_reason;  // for a person
  core::UtcTime departure{};
  core::UtcTime finished{};
  std::vector<TrackPoint> track;  // first and last moment included
  std::vector<FlightEvent> events;
  std::vector<ClosestApproach> approaches;  // to the sea bed, the sea ice and each body within reach
  SensorLog sensors;
  core::Joules energy{};
  double distance_m{};  // over ground, horizontal
  int teeth{};          // full dives and climbs

  [[nodiscard]] core::Seconds duration() const { return finished - departure; }

  friend bool operator==(const FlightRecord&, const FlightRecord&) = default;
};

}  // namespace floeplan::simulation

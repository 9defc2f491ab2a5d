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

/// What one simulated flight leaves behind. Places are in the frame of the flight's world, energy is drawn since the
/// start.
namespace floeplan::simulation {

/// A moment of the track.
struct TrackPoint {
  core::UtcTime time{};
  Vector position{};     // where the vehicle really is
  Vector believed{};     // where its dead reckoning and its depth sensor put it
  double sigma_m{};      // of `believed` as the vehicle states it, one sigma of east and of north
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
  guidance,  // the system on board changes its mode
  contact,   // with a body, the sea bed or the ice
  end        // why is FlightRecord::end
};

struct FlightEvent {
  core::UtcTime time{};
  EventKind kind{};
  Vector position{};
  std::string text;  // for a person; empty where the kind says it all

  friend bool operator==(const FlightEvent&, const FlightEvent&) = default;
};

/// Nearest that the vehicle came to something.
struct ClosestApproach {
  std::string to;  // "sea bed", "sea ice" or the name of a body
  double distance_m{};
  core::UtcTime time{};
  Vector position{};  // of the vehicle

  friend bool operator==(const ClosestApproach&, const ClosestApproach&) = default;
};

struct SonarEntry {  // a ping that returned something
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

struct CurrentEntry {  // a bin of an ADCP's profile
  core::UtcTime time{};
  double depth_m{};
  geo::VelocityEn measured{};
  core::MetresPerSecond one_sigma{};

  friend bool operator==(const CurrentEntry&, const CurrentEntry&) = default;
};

struct FixEntry {
  core::UtcTime time{};
  Vector fixed{};                    // by GPS
  Vector believed{};                 // before the fix
  geo::VelocityEn depth_averaged{};  // current since the fix before, as the vehicle computes it

  friend bool operator==(const FixEntry&, const FixEntry&) = default;
};

/// What the sensors told, thinned where a flight is long.
struct SensorLog {
  std::vector<SonarEntry> sonar;
  std::vector<AltimeterEntry> altimeter;
  std::vector<CurrentEntry> currents;
  std::vector<FixEntry> fixes;

  friend bool operator==(const SensorLog&, const SensorLog&) = default;
};

enum class FlightEnd : std::uint8_t {
  arrived,    // the last waypoint was reached, and the vehicle came up there
  collided,   // with a body or the sea ice
  grounded,   // on the sea bed
  gave_up,    // the mission or the system on board ended it, or ice at the goal turned the vehicle back
  time_up,    // longer than the settings allow
  battery,    // below the reserve
  left_data,  // where the world is not known
  stopped     // on request: the record is not whole
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
  std::vector<ClosestApproach> approaches;  // one for the sea bed, the sea ice and each body come near
  SensorLog sensors;
  core::Joules energy{};
  double distance_m{};  // over ground, horizontal
  int teeth{};          // full dives and climbs

  [[nodiscard]] core::Seconds duration() const { return finished - departure; }

  friend bool operator==(const FlightRecord&, const FlightRecord&) = default;
};

}  // namespace floeplan::simulation

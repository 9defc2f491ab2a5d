#pragma once

#include <optional>
#include <span>

#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/geo/velocity.hpp"

/// The data of sensors and of the vehicle's computer: the only input of the avoidance system.
/// Frame    places are in one local plane for the whole flight, x east and y north, metres; depth is positive
///          down. Body axes point forward, starboard and down. Angles are radians, headings clockwise from
///          true north
/// Spans    are borrowed: read during the call only, and not kept
namespace floeplan::avoidance {

/// A direction or place relative to the vehicle, in its body axes.
struct BodyVector {
  double forward{};
  double starboard{};
  double down{};

  friend bool operator==(const BodyVector&, const BodyVector&) = default;
};

/// Attitude of the vehicle in the water.
struct Attitude {
  core::Radians heading{};  // where the nose points, clockwise from true north
  core::Radians pitch{};    // nose up positive
  core::Radians roll{};     // starboard side down positive

  friend bool operator==(const Attitude&, const Attitude&) = default;
};

/// One echo above the sonar's threshold, from a body, the sea bed or the ice; or a false alarm.
struct SonarReturn {
  core::Metres range{};    // along the beam
  BodyVector beam{};       // unit vector of the beam's axis
  double echo_level_db{};  // re 1 micropascal at the receiver

  friend bool operator==(const SonarReturn&, const SonarReturn&) = default;
};

/// All echoes of one transmission; those beyond `most_returns` are ignored.
struct SonarPing {
  static constexpr std::size_t most_returns = 512;

  core::UtcTime time{};
  std::span<const SonarReturn> returns{};
};

/// The current at one depth, from ADCP and processing.
struct CurrentBin {
  core::Metres depth{};
  geo::VelocityEn velocity{};         // of the water over the ground
  core::MetresPerSecond one_sigma{};  // standard deviation of each component

  friend bool operator==(const CurrentBin&, const CurrentBin&) = default;
};

struct CurrentProfile {
  core::UtcTime time{};
  std::span<const CurrentBin> bins{};
};

/// The vehicle's estimate of its own state: dead reckoning, compass, pressure and altimeter. The place may
/// jump when a fix corrects it.
struct OwnState {
  core::UtcTime time{};
  geo::PlanePoint place{};
  core::Metres place_sigma{};  // standard deviation of east and of north
  core::Metres depth{};
  Attitude attitude{};
  core::MetresPerSecond through_water{};   // horizontal speed through the water
  std::optional<core::Metres> altitude{};  // above the sea bed; empty: the altimeter has no echo
  bool at_surface{};                       // true: the vehicle drifts and cannot steer
  std::size_t waypoint{};                  // index of the mission's waypoint that the autopilot steers for

  friend bool operator==(const OwnState&, const OwnState&) = default;
};

/// The data since the last step. Times never go back.
struct Sensed {
  OwnState own{};
  std::optional<SonarPing> sonar{};
  std::optional<CurrentProfile> current{};
};

}  // namespace floeplan::avoidance

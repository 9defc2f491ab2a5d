#pragma once

#include <optional>
#include <span>

#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/geo/velocity.hpp"

/// What the sensors and the vehicle's own computer tell the system on board: all that it ever knows.
/// Frame    places lie in one local plane for the whole flight, x east and y north, metres; depth is positive down.
///          Body axes point forward, starboard and down. Angles are radians, headings clockwise from true north
/// Borrowed spans are read during the call that they are given to, and not kept
namespace floeplan::avoidance {

/// A direction or a place seen from the vehicle, in its body axes.
struct BodyVector {
  double forward{};
  double starboard{};
  double down{};

  friend bool operator==(const BodyVector&, const BodyVector&) = default;
};

/// How the vehicle lies in the water.
struct Attitude {
  core::Radians heading{};  // where the nose points, clockwise from true north
  core::Radians pitch{};    // nose up positive
  core::Radians roll{};     // starboard side down positive

  friend bool operator==(const Attitude&, const Attitude&) = default;
};

/// One echo above the sonar's threshold: a body's, the sea bed's, the ice's or a false alarm.
struct SonarReturn {
  core::Metres range{};    // along the beam
  BodyVector beam{};       // unit vector of the beam's axis
  double echo_level_db{};  // re 1 micropascal at the receiver

  friend bool operator==(const SonarReturn&, const SonarReturn&) = default;
};

/// All echoes of one transmission; beyond `most_returns` they are left out.
struct SonarPing {
  static constexpr std::size_t most_returns = 512;

  core::UtcTime time{};
  std::span<const SonarReturn> returns{};
};

/// What an ADCP and the detection after it say of the current at one depth.
struct CurrentBin {
  core::Metres depth{};
  geo::VelocityEn velocity{};         // of the water over the ground
  core::MetresPerSecond one_sigma{};  // of either component

  friend bool operator==(const CurrentBin&, const CurrentBin&) = default;
};

struct CurrentProfile {
  core::UtcTime time{};
  std::span<const CurrentBin> bins{};
};

/// What the vehicle believes of itself: its dead reckoning, compass, pressure and altimeter. The place may jump when
/// a position fix corrects it.
struct OwnState {
  core::UtcTime time{};
  geo::PlanePoint place{};
  core::Metres place_sigma{};  // one sigma of east and of north
  core::Metres depth{};
  Attitude attitude{};
  core::MetresPerSecond through_water{};   // horizontal speed through the water
  std::optional<core::Metres> altitude{};  // above the sea bed, where the altimeter has an echo
  bool at_surface{};                       // the vehicle drifts and does not steer
  std::size_t waypoint{};                  // of the mission, that its autopilot steers for

  friend bool operator==(const OwnState&, const OwnState&) = default;
};

/// What reached the system since its last step. Times never go back.
struct Sensed {
  OwnState own{};
  std::optional<SonarPing> sonar{};
  std::optional<CurrentProfile> current{};
};

}  // namespace floeplan::avoidance

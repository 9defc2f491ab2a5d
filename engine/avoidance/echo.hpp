#pragma once

#include "engine/avoidance/sensed.hpp"
#include "engine/avoidance/settings.hpp"
#include "engine/geo/local_projection.hpp"

namespace floeplan::avoidance {

/// Place of a sonar echo: on the axis of its beam, with the beam's half height above and below at that range.
struct Echo {
  geo::PlanePoint place{};  // water frame
  double depth_m{};
  double range_m{};
  double shallowest_m{};
  double deepest_m{};

  friend bool operator==(const Echo&, const Echo&) = default;
};

/// A vector in level axes: metres east, north and down.
struct LevelVector {
  double east{};
  double north{};
  double down{};
};

/// Rotates a vector from body axes to level axes, by heading, then pitch, then roll.
[[nodiscard]] LevelVector levelled(const BodyVector& body, const Attitude& attitude);

[[nodiscard]] Echo placed(const SonarReturn& sonar, const OwnState& own, geo::PlanePoint own_in_water,
                          const SonarView& view);

/// Whether the return can be a body's echo: finite, with a positive range within `reach`.
[[nodiscard]] bool is_usable(const SonarReturn& sonar, core::Metres reach);

}  // namespace floeplan::avoidance

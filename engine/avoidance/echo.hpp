#pragma once

#include "engine/avoidance/sensed.hpp"
#include "engine/avoidance/settings.hpp"
#include "engine/geo/local_projection.hpp"

namespace floeplan::avoidance {

/// Where a sonar return came from: on the axis of its beam, and how far above or below it at that range.
struct Echo {
  geo::PlanePoint place{};  // water frame
  double depth_m{};
  double range_m{};
  double shallowest_m{};
  double deepest_m{};

  friend bool operator==(const Echo&, const Echo&) = default;
};

/// A vector of the body axes, seen from above: metres east, north and down.
struct LevelVector {
  double east{};
  double north{};
  double down{};
};

/// Turns body axes into level ones: heading, then pitch, then roll.
[[nodiscard]] LevelVector levelled(const BodyVector& body, const Attitude& attitude);

[[nodiscard]] Echo placed(const SonarReturn& sonar, const OwnState& own, geo::PlanePoint own_in_water,
                          const SonarView& view);

/// Whether it can be a body's: finite, of a range above zero and within the reach.
[[nodiscard]] bool is_usable(const SonarReturn& sonar, core::Metres reach);

}  // namespace floeplan::avoidance

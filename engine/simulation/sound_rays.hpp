#pragma once

#include <optional>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/simulation/sonar_echo.hpp"
#include "engine/simulation/space.hpp"
#include "engine/simulation/world.hpp"

namespace floeplan::simulation {

/// What straight rays of sound meet in a world at one instant: bodies, sea bed, sea ice and the open surface.
/// Model    the ice is level over the length of a ray; a slope of the sea bed steeper than 60 degrees may be met late
/// Memory   keeps room for the bodies at hand from one instant to the next
/// Threads  one at a time
class SoundRays {
 public:
  /// `world` is borrowed. `reach` is the longest ray ever asked for.
  SoundRays(const World& world, core::Metres reach);

  /// Takes up the rays of one instant from one place.
  void look_from(Vector place, core::UtcTime time);

  /// Precondition `origin` is the place looked from
  [[nodiscard]] std::optional<RayHit> operator()(Vector origin, Vector direction, double max_range_m) const;

 private:
  [[nodiscard]] std::optional<RayHit> surface_hit(Vector origin, Vector direction, double max_range_m) const;
  [[nodiscard]] std::optional<RayHit> bed_hit(Vector origin, Vector direction, double max_range_m) const;
  [[nodiscard]] bool bed_within_reach(Vector place) const;
  /// How far the sea bed lies below a place; empty where there is none.
  [[nodiscard]] std::optional<double> above_bed(Vector place) const;

  const World& world_;
  double reach_m_;
  NearbyBodies nearby_;
  std::vector<NearbyBodies::Posed> bodies_;
  core::UtcTime time_{};
  bool near_bed_{};
};

}  // namespace floeplan::simulation

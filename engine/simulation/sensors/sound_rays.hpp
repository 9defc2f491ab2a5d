#pragma once

#include <optional>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/simulation/sensors/sonar_echo.hpp"
#include "engine/simulation/world/local_bed.hpp"
#include "engine/simulation/world/space.hpp"
#include "engine/simulation/world/world.hpp"

namespace floeplan::simulation {

/// What straight rays of sound meet in a world at one instant: bodies, sea bed, sea ice and the open surface.
/// Model    the ice is level over the length of a ray; the sea bed is that of a LocalBed
/// Memory   keeps room for the bodies at hand from one instant to the next
/// Threads  one at a time
class SoundRays {
 public:
  /// `world` is borrowed. `reach` is the longest ray ever asked for.
  SoundRays(const World& world, core::Metres reach);

  /// Takes up the rays of one instant from one place.
  void look_from(Vector place, core::UtcTime time);

  /// Whether a ray of that reach can meet nothing but the open surface.
  [[nodiscard]] bool is_open_water() const { return bodies_.empty() && !near_bed_ && !world_.has_ice(); }

  /// Precondition `origin` is the place looked from
  [[nodiscard]] std::optional<RayHit> operator()(Vector origin, Vector direction, double max_range_m) const;

 private:
  /// A body within reach and the ball that holds it, seen from the place looked from.
  struct InReach {
    NearbyBodies::Posed posed;
    Vector centre{};
    double centre_m2{};  // its distance, squared
    double radius_m{};

    [[nodiscard]] bool is_missed_by(Vector direction, double max_range_m) const;
  };

  [[nodiscard]] std::optional<RayHit> surface_hit(Vector origin, Vector direction, double max_range_m) const;
  [[nodiscard]] std::optional<RayHit> bed_hit(Vector origin, Vector direction, double max_range_m) const;
  [[nodiscard]] double cosine_on_bed(Vector foot, Vector direction) const;

  const World& world_;
  double reach_m_;
  NearbyBodies nearby_;
  LocalBed bed_;
  std::vector<InReach> bodies_;
  core::UtcTime time_{};
  bool near_bed_{};
};

}  // namespace floeplan::simulation

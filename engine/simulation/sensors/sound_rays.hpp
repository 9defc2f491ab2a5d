#pragma once

#include <optional>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/simulation/sensors/sonar_echo.hpp"
#include "engine/simulation/world/local_bed.hpp"
#include "engine/simulation/world/space.hpp"
#include "engine/simulation/world/world.hpp"

namespace floeplan::simulation {

/// The surfaces that straight rays of sound meet in a world at one instant: bodies, sea bed, sea ice and the
/// open surface.
/// Model    the ice is level over the length of a ray; the sea bed is that of a LocalBed
/// Memory   keeps a buffer for the bodies within reach
/// Threads  one at a time
class SoundRays {
 public:
  /// `world` is borrowed. `reach`: longest ray that will be asked for.
  SoundRays(const World& world, core::Metres reach);

  /// Prepares rays from one place at one instant.
  void look_from(Vector place, core::UtcTime time);

  /// Whether rays of this length can meet only the open surface.
  [[nodiscard]] bool is_open_water() const { return bodies_.empty() && !near_bed_ && !world_.has_ice(); }

  /// Precondition `origin` is the place of the last `look_from`
  [[nodiscard]] std::optional<RayHit> operator()(Vector origin, Vector direction, double max_range_m) const;

 private:
  /// A body within reach, and its bounding ball as seen from the place of `look_from`.
  struct InReach {
    NearbyBodies::Posed posed;
    Vector centre{};
    double centre_m2{};  // squared distance of the ball's centre
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

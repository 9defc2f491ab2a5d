#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/simulation/world/body.hpp"
#include "engine/simulation/world/ice_layer.hpp"
#include "engine/simulation/world/sea_bed.hpp"
#include "engine/simulation/world/space.hpp"
#include "engine/simulation/world/true_current.hpp"

namespace floeplan::simulation {

/// The parts of a world; a part that is left out does not exist in it.
struct WorldParts {
  geo::LonLat origin{};  // origin of the flight's frame
  SeaBed bed{};
  IceLayer ice{};
  TrueCurrent current{};
  std::vector<Body> bodies{};
};

/// The true sea around one flight, as functions of place, depth and time. The vehicle knows it only through
/// its sensors.
/// Frame    the plane of geo::LocalProjection around the origin: metres east and north of it, depth positive
///          down
/// Threads  const members may be called from several threads at once
class World {
 public:
  explicit World(WorldParts parts);

  /// Depth of the sea bed; empty if there is none or it is unknown.
  [[nodiscard]] std::optional<double> bed_depth_m(double east_m, double north_m) const {
    return parts_.bed.depth_m(east_m, north_m);
  }
  /// Depth of the underside of the sea ice; zero in open water.
  [[nodiscard]] double ice_draft_m(double east_m, double north_m, core::UtcTime time) const {
    return parts_.ice.draft_m(east_m, north_m, time);
  }
  [[nodiscard]] bool has_ice() const { return parts_.ice.has_ice(); }
  /// Velocity of the water, m/s; empty outside the data.
  [[nodiscard]] std::optional<Vector> current(Vector place, core::UtcTime time) const {
    return parts_.current.at(place, time);
  }
  [[nodiscard]] const TrueCurrent& true_current() const { return parts_.current; }
  [[nodiscard]] std::span<const Body> bodies() const { return parts_.bodies; }
  /// Whether depth and current are known at this place and time.
  [[nodiscard]] bool covers(Vector place, core::UtcTime time) const;

  [[nodiscard]] const geo::LocalProjection& projection() const { return projection_; }
  [[nodiscard]] Vector to_frame(geo::LonLat place, double depth_m = 0.0) const;
  [[nodiscard]] geo::LonLat to_lon_lat(Vector place) const;

  /// Indices of the bodies of which any part may be within `reach_m` of the place between the two times.
  [[nodiscard]] std::vector<std::uint32_t> bodies_near(Vector place, double reach_m, core::UtcTime from,
                                                       core::UtcTime to) const;

 private:
  WorldParts parts_;
  geo::LocalProjection projection_;
};

/// The bodies near a vehicle. They are searched from time to time and serve all queries between, so that a
/// ping need not test every iceberg. Memory grows with the number of near bodies; between two searches
/// nothing is allocated.
/// Threads  one instance for each flight
class NearbyBodies {
 public:
  struct Posed {
    const Body* body{};
    std::uint32_t index{};  // into World::bodies
    BodyPose pose{};
  };

  /// `world` is borrowed. `reach`: largest distance of bodies that will be asked for.
  NearbyBodies(const World& world, core::Metres reach);

  /// All bodies with a part within reach of the place, and a few others, with their pose at that time. Valid
  /// until the next call. Times must not fall from call to call.
  [[nodiscard]] std::span<const Posed> at(Vector place, core::UtcTime time);

 private:
  const World& world_;
  double reach_m_;
  std::vector<Posed> near_;
  bool sought_{};
  core::UtcTime good_until_{};
  Vector sought_at_{};
};

}  // namespace floeplan::simulation

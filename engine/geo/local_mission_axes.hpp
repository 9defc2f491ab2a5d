#pragma once

#include "engine/core/units.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/geo/velocity.hpp"

namespace floeplan::geo {

/// Horizontal velocity in a Slocum's local mission coordinates: along the axes of LocalMissionAxes.
struct VelocityLmc {
  core::MetresPerSecond x{};
  core::MetresPerSecond y{};

  friend bool operator==(VelocityLmc, VelocityLmc) = default;
};

/// Zone of the UTM grid that a longitude lies in, 1 to 60: six degrees wide at every latitude.
[[nodiscard]] int utm_zone_of(LonLat place);

/// The same with the standard's wider zones of Norway and Svalbard. A vehicle whose log does not name its zone may
/// follow either.
[[nodiscard]] int standard_utm_zone_of(LonLat place);

/// Axes of a Slocum's local mission coordinates (LMC), in which it logs m_water_vx and _vy, m_initial_water_vx and _vy,
/// m_final_water_vx and _vy, m_vx_lmc and m_vy_lmc: the grid of the UTM zone where its mission began, turned by the
/// magnetic variation at that time, so that y points about to magnetic north. They stay while the vehicle goes on.
/// Frame    with the variation V, west positive as m_gps_mag_var has it (declination D = -V, east positive), and the
///          convergence C, by which the zone's grid north bears to the east of true north, the axes are turned from
///          east and north by V - C, anticlockwise positive: y bears C - V
/// Accuracy convergence of the ellipsoid to 1e-9 degrees, since a mission may leave its zone, where the usual
///          (longitude - central meridian) * sin(latitude) is off by 0.04 degrees two zones away
/// Threads  const members may be called from several threads at once
/// Source   x_utm_to_lmc_00 to _11 of real logs, which are cos V, sin V, -sin V, cos V; the axes of four logs at 38.5 N
///          63 W and of two in the German Bight agree to 0.02 degrees. Convergence: GeographicLib's TransverseMercator,
///          after Karney 2011, J. Geodesy 85, 475-485
class LocalMissionAxes {
 public:
  /// Errors   std::invalid_argument for a zone outside 1 to 60 or a variation that is not finite
  LocalMissionAxes(int utm_zone, core::Radians variation_west);

  [[nodiscard]] int utm_zone() const { return utm_zone_; }
  [[nodiscard]] core::Radians variation_west() const { return variation_west_; }

  /// Angle from true east to x, and from true north to y, at a place; anticlockwise positive.
  [[nodiscard]] core::Radians turn_at(LonLat place) const;
  [[nodiscard]] VelocityEn to_true(VelocityLmc velocity, LonLat place) const;
  [[nodiscard]] VelocityLmc to_lmc(VelocityEn velocity, LonLat place) const;

  friend bool operator==(LocalMissionAxes, LocalMissionAxes) = default;

 private:
  int utm_zone_;
  core::Radians variation_west_;
};

}  // namespace floeplan::geo

#pragma once

#include "engine/core/units.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/geo/velocity.hpp"

namespace floeplan::geo {

/// Horizontal velocity in a Slocum's local mission coordinates (see LocalMissionAxes).
struct VelocityLmc {
  core::MetresPerSecond x{};
  core::MetresPerSecond y{};

  friend bool operator==(VelocityLmc, VelocityLmc) = default;
};

/// The UTM zone of a longitude, 1 to 60: zones six degrees wide at every latitude.
[[nodiscard]] int utm_zone_of(LonLat place);

/// The UTM zone of a place with the standard's wider zones of Norway and Svalbard. If a log does not name the
/// zone, the vehicle may use this rule or the rule of `utm_zone_of`.
[[nodiscard]] int standard_utm_zone_of(LonLat place);

/// Axes of a Slocum's local mission coordinates (LMC). In them it logs m_water_vx and _vy, m_initial_water_vx
/// and _vy, m_final_water_vx and _vy, m_vx_lmc and m_vy_lmc. They are the grid axes of the UTM zone where the
/// mission began, rotated by the magnetic variation at that time, so that y points about to magnetic north.
/// They stay constant during the mission.
/// Frame    V: variation, west positive as in m_gps_mag_var (declination D = -V, east positive). C:
///          convergence, the bearing of the zone's grid north from true north. The axes are rotated from east
///          and north by V - C, anticlockwise positive: the bearing of y is C - V
/// Accuracy convergence of the ellipsoid to 1e-9 degrees. A mission may leave its zone, and two zones away
/// the usual (longitude - central meridian) * sin(latitude) is wrong by 0.04 degrees
/// Threads  const members may be called from several threads at once
/// Source   x_utm_to_lmc_00 to _11 of real logs, which are cos V, sin V, -sin V, cos V; the axes of four logs
///          at 38.5 N 63 W and of two in the German Bight agree to 0.02 degrees. Convergence: GeographicLib's
///          TransverseMercator, after Karney 2011, J. Geodesy 85, 475-485
class LocalMissionAxes {
 public:
  /// Errors   std::invalid_argument for a zone outside 1 to 60 or a variation that is not finite
  LocalMissionAxes(int utm_zone, core::Radians variation_west);

  [[nodiscard]] int utm_zone() const { return utm_zone_; }
  [[nodiscard]] core::Radians variation_west() const { return variation_west_; }

  /// Angle from true east to x, which equals that from true north to y, at a place; anticlockwise positive.
  [[nodiscard]] core::Radians turn_at(LonLat place) const;
  [[nodiscard]] VelocityEn to_true(VelocityLmc velocity, LonLat place) const;
  [[nodiscard]] VelocityLmc to_lmc(VelocityEn velocity, LonLat place) const;

  friend bool operator==(LocalMissionAxes, LocalMissionAxes) = default;

 private:
  int utm_zone_;
  core::Radians variation_west_;
};

}  // namespace floeplan::geo

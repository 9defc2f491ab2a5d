#pragma once

#include <cmath>
#include <cstdio>
#include <string>

#include "engine/simulation/flight/flight_record.hpp"
#include "engine/simulation/world/world.hpp"

namespace floeplan::support {

/// An angle as a vehicle logs it: degrees and minutes packed into one number.
inline double packed(double angle_deg) {
  const double whole = angle_deg < 0.0 ? -static_cast<double>(static_cast<int>(-angle_deg))
                                       : static_cast<double>(static_cast<int>(angle_deg));
  return 100.0 * whole + 60.0 * (angle_deg - whole);
}

/// Magnetic variation of these logs, west positive.
inline constexpr double logged_variation_rad = 0.3;

/// A simulated flight written as the log of a Slocum that surfaces once, for tests of the readers of logs.
/// The current goes into the log in the vehicle's own axes, whose y bears the convergence of the UTM grid
/// less the variation.
inline std::string log_of(const simulation::FlightRecord& record, const simulation::World& world,
                          geo::LonLat waypoint, double pump_cc, double current_east, double current_north) {
  using simulation::EventKind;
  std::string text =
      "# mission\nm_present_time,m_lat,m_lon,m_gps_lat,m_gps_lon,x_dr_state,m_depth,m_pitch,m_ballast_pumped,"
      "m_water_vx,m_water_vy,m_initial_water_vx,m_initial_water_vy,c_wpt_lat,c_wpt_lon,m_gps_mag_var\n"
      "timestamp,lat,lon,lat,lon,enum,m,rad,cc,m/s,m/s,m/s,m/s,lat,lon,rad\n";
  core::UtcTime surfaced{};
  core::UtcTime fixed{};
  for (const auto& event : record.events) {
    if (event.kind == EventKind::surfacing) surfaced = event.time;
    if (event.kind == EventKind::fix && fixed == core::UtcTime{}) fixed = event.time;
  }
  const geo::LonLat start = world.projection().origin();
  const double meridian_deg = -177.0 + 6.0 * std::floor((start.lon_deg + 180.0) / 6.0);
  const double y_bears_rad = core::degrees_to_radians(start.lon_deg - meridian_deg) *
                                 std::sin(core::degrees_to_radians(start.lat_deg)) -
                             logged_variation_rad;
  const double current_x = current_east * std::cos(y_bears_rad) - current_north * std::sin(y_bears_rad);
  const double current_y = current_east * std::sin(y_bears_rad) + current_north * std::cos(y_bears_rad);
  for (const auto& point : record.track) {
    const bool up = surfaced != core::UtcTime{} && point.time >= surfaced;
    const bool has_fix = up && point.time >= fixed;
    const geo::LonLat place = world.to_lon_lat(point.position);
    const double pump = point.over_ground.down > 0.0 ? -pump_cc : pump_cc;
    char row[400];
    std::snprintf(
        row, sizeof row, "%.1f,%.6f,%.6f,%.6f,%.6f,%d,%.3f,%.4f,%.1f,0,0,%.6f,%.6f,%.4f,%.4f,%.4f\n",
        core::unix_seconds(point.time), packed(up ? place.lat_deg : start.lat_deg),
        packed(up ? place.lon_deg : start.lon_deg), has_fix ? packed(place.lat_deg) : 69696969.0,
        has_fix ? packed(place.lon_deg) : 69696969.0, has_fix ? 3 : (up ? 2 : 1), point.position.down,
        point.attitude.pitch_rad, pump, has_fix ? current_x : 0.0, has_fix ? current_y : 0.0,
        packed(waypoint.lat_deg), packed(waypoint.lon_deg), logged_variation_rad);
    text += row;
  }
  return text;
}

}  // namespace floeplan::support

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/geo/velocity.hpp"
#include "engine/ocean/currents/vehicle_axes.hpp"

namespace floeplan::simulation {

/// One dive between two surfacings as a Slocum logged it, and the settings that can be read from the log.
struct LoggedSegment {
  core::UtcTime dived{};
  core::UtcTime surfaced{};
  core::UtcTime fixed{};             // first fix after surfacing
  geo::LonLat start{};               // last fix before the dive
  geo::LonLat end{};                 // first fix after surfacing
  geo::VelocityEn reckoned_with{};   // current assumed for steering and dead reckoning on the dive
  geo::VelocityEn depth_averaged{};  // mean current of this dive, by the vehicle's estimate after it
  ocean::VehicleAxes turned_from;    // the vehicle's axes, in which both currents are logged
  std::string
      positions_read{};  // note on how positions were read; empty: they were in the vehicle's own notation
  struct Waypoint {
    geo::LonLat place{};
    std::optional<core::Metres> reached_within{};  // distance when it turned to the next, by dead reckoning
  };
  std::vector<Waypoint> waypoints;  // waypoints that it steered for, in order
  core::Seconds until_ascent{};     // from the beginning of the dive to the middle of its last climb
  int dives{};                      // number of dives begun
  core::Metres turns_down_at{};  // median depths at which the pump starts to push it up, and to let it sink
  core::Metres turns_up_at{};
  core::Radians dive_pitch{};  // nose up positive
  core::Radians climb_pitch{};
  core::CubicMetres dive_buoyancy{};  // up positive
  core::CubicMetres climb_buoyancy{};
  core::MetresPerSecond sinks{};  // medians of the vertical speeds half-way between turns
  core::MetresPerSecond rises{};

  [[nodiscard]] core::Seconds under_water() const { return surfaced - dived; }
  /// Excess buoyancy over the ballasting: why it rises faster than it sinks. The squares of the vertical
  /// speeds are proportional to the net buoyancy.
  [[nodiscard]] core::CubicMetres trim() const;
};

/// Reads the dives of a Slocum's log from text. Either comma-separated: a line of sensor names, a line of
/// units, rows in order of time; lines that begin with # and empty fields are skipped. Or the text that the
/// vendor's program dbd2asc makes of a binary log. Positions are packed degrees and minutes, as the vehicle
/// has them, or decimal degrees (see settle_positions); 69696969 is no position.
/// Needs    m_present_time, m_lat, m_lon, m_gps_lat, m_gps_lon, m_depth, m_pitch, x_dr_state, m_water_vx,
///          m_water_vy, c_wpt_lat, c_wpt_lon, m_initial_water_vx and _vy (or m_final_water_...),
///          m_ballast_pumped or m_de_oil_vol
/// Edges    a dive whose log does not reach a fix after it is left out
/// Currents rotated from the vehicle's axes to true east and north at the place where each dive ended: see
/// ocean::LoggedAxes
/// Errors   every violation at once: missing columns, rows that are not numbers, no complete dive, unknown
///          axes
/// Bounds   256 MiB of text
/// Source   x_dr_state 1: under water, 2: waits for the first fix, 3: for the next, 4: ready to dive, of the
///          vendor's data dictionary of firmware 10.5
[[nodiscard]] tl::expected<std::vector<LoggedSegment>, core::Violations> read_glider_log(
    std::string_view text);

}  // namespace floeplan::simulation

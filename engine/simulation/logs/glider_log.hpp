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

/// One dive between two times at the surface as a Slocum logged it, and the settings that can be read from the log.
struct LoggedSegment {
  core::UtcTime dived{};
  core::UtcTime surfaced{};
  core::UtcTime fixed{};             // first position after that
  geo::LonLat start{};               // when it dived, by its fix
  geo::LonLat end{};                 // first position after coming up
  geo::VelocityEn reckoned_with{};   // current that it steered and reckoned with on the dive
  geo::VelocityEn depth_averaged{};  // current of this dive, by the vehicle's own estimate after it
  ocean::VehicleAxes turned_from;    // both: the vehicle's own axes, in which it logs them
  std::string
      positions_read{};  // what to know of how the log's positions were read; empty: as the vehicle has them
  struct Waypoint {
    geo::LonLat place{};
    std::optional<core::Metres> reached_within{};  // when it turned to the next, by its dead reckoning
  };
  std::vector<Waypoint> waypoints;  // that it steered for, in order
  core::Seconds until_ascent{};     // from the dive to the middle of its last climb
  int dives{};                      // begun
  core::Metres turns_down_at{};  // medians: depth at which the pump begins to push it up, and to let it sink
  core::Metres turns_up_at{};
  core::Radians dive_pitch{};  // nose up positive
  core::Radians climb_pitch{};
  core::CubicMetres dive_buoyancy{};  // up positive
  core::CubicMetres climb_buoyancy{};
  core::MetresPerSecond sinks{};  // medians of the rates of depth halfway between the turns
  core::MetresPerSecond rises{};

  [[nodiscard]] core::Seconds under_water() const { return surfaced - dived; }
  /// How much lighter than ballasted for the vehicle was: what makes it rise faster than it sinks. The squares of the
  /// rates go with the net buoyancy.
  [[nodiscard]] core::CubicMetres trim() const;
};

/// Reads the dives of a Slocum's log as comma-separated text: a line of sensor names, a line of units, rows in the
/// order of time; lines that begin with # and empty fields are left out. Or as the vendor's program dbd2asc turns a
/// binary log into text. Positions are packed degrees and minutes, as the
/// vehicle has them, or decimal degrees (see settle_positions); 69696969 is no position.
/// Needs    m_present_time, m_lat, m_lon, m_gps_lat, m_gps_lon, m_depth, m_pitch, x_dr_state, m_water_vx, m_water_vy,
///          c_wpt_lat, c_wpt_lon, m_initial_water_vx and _vy (or m_final_water_...), m_ballast_pumped or m_de_oil_vol
/// Edges    a dive that the log does not follow to a fix after it is left out
/// Currents are turned from the vehicle's own axes to true east and north where each dive ended: see ocean::LoggedAxes.
/// Errors   every violation at once: columns that are missing, rows that are not numbers, no whole dive, axes that
///          nothing tells
/// Bounds   256 MiB of text
/// Source   x_dr_state 1: under water, 2: waits for the first fix, 3: for the next, 4: ready to dive, of the vendor's
///          data dictionary of firmware 10.5
[[nodiscard]] tl::expected<std::vector<LoggedSegment>, core::Violations> read_glider_log(
    std::string_view text);

}  // namespace floeplan::simulation

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/geo/velocity.hpp"
#include "storage/ingest/common/refusal.hpp"

namespace floeplan::ingest {

/// Whether a text begins like a Seaglider's file of a dive: its log, or its engineering record.
[[nodiscard]] bool is_seaglider_log(std::string_view head);
[[nodiscard]] bool is_seaglider_record(std::string_view head);

/// Vehicle and dive of a file, from its first lines.
struct SeagliderDive {
  std::string glider;   // "sg561"; empty: unknown
  std::string mission;  // "sg561 mission 6": equal for all dives of one mission
  int dive{};
  core::UtcTime start;
};
[[nodiscard]] Checked<SeagliderDive> seaglider_dive_of(std::string_view text);

struct SeagliderFix {
  core::UtcTime time;
  geo::LonLat place;
};

/// Positions and current of a dive, from its log.
struct SeagliderLog {
  SeagliderDive dive;
  std::optional<SeagliderFix> before{};      // $GPS1: fix after it surfaced from the dive before
  std::optional<SeagliderFix> dived{};       // $GPS2: last fix before the dive
  std::optional<SeagliderFix> surfaced{};    // $GPS: first fix after the dive
  std::optional<geo::VelocityEn> current{};  // depth-averaged over the dive, as estimated by the vehicle
  std::int64_t fixes_left_out{};             // fixes without a position, or too far in time from their dive
};

/// Reads a log. A $GPS line has date (ddmmyy), time (hhmm or hhmmss), latitude and longitude in packed
/// degrees; a horizontal dilution of 99 means no fix. $CURRENT, since firmware 67, has the speed in m/s, the
/// direction of flow in degrees from true north, and whether it is valid. That it is the average over the
/// dive and refers to true north is inferred: in dive 1 of sg180 (2026) it is 0.275 m/s towards 9.0 degrees,
/// and the basestation computes 0.261 m/s towards 9.2; the magnetic variation is 15.1 degrees.
/// Source   iop-apl-uw/basestation3 GPS.py and LogFile.py
/// Errors   no glider, dive or start time
[[nodiscard]] Checked<SeagliderLog> read_seaglider_log(std::string_view text);

struct SeagliderDepth {
  core::UtcTime time;
  core::Metres depth;
};

/// Reads the columns elaps_t, seconds since the start of the dive, and depth, in centimetres, the unit that
/// the basestation states for this column in its NetCDF. Rows whose depth is not a number are skipped.
/// Errors   no glider, dive or start time; no such columns
[[nodiscard]] Checked<std::vector<SeagliderDepth>> read_seaglider_record(std::string_view text);

}  // namespace floeplan::ingest

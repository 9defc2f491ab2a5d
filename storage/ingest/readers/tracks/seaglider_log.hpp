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

/// Whether a text begins as what a Seaglider writes of a dive: its log, or its engineering record.
[[nodiscard]] bool is_seaglider_log(std::string_view head);
[[nodiscard]] bool is_seaglider_record(std::string_view head);

/// Which dive of which vehicle a file is of, by its first lines.
struct SeagliderDive {
  std::string glider;   // "sg561"; empty: the file does not say
  std::string mission;  // "sg561 mission 6": the same of all dives of one mission
  int dive{};
  core::UtcTime start;
};
[[nodiscard]] Checked<SeagliderDive> seaglider_dive_of(std::string_view text);

struct SeagliderFix {
  core::UtcTime time;
  geo::LonLat place;
};

/// What a log tells of the way of its dive.
struct SeagliderLog {
  SeagliderDive dive;
  std::optional<SeagliderFix> before{};      // $GPS1: as it came up from the dive before
  std::optional<SeagliderFix> dived{};       // $GPS2: the last one before it dived
  std::optional<SeagliderFix> surfaced{};    // $GPS: the first one after the dive
  std::optional<geo::VelocityEn> current{};  // of the dive, as the vehicle estimates it
  std::int64_t fixes_left_out{};             // without a place, or more than a day from their dive
};

/// $GPS lines are date (ddmmyy), time (hhmm or hhmmss), latitude and longitude in packed degrees; a horizontal dilution
/// of 99 is no fix. $CURRENT, of firmware 67 on, is speed in m/s, direction in degrees towards which it flows from true
/// north, and whether it is valid; that it is the average over the dive and true is inferred: in dive 1 of sg180 (2026)
/// it is 0.275 m/s towards 9.0 degrees where the basestation computes 0.261 m/s towards 9.2, with a variation of 15.1.
/// Source   iop-apl-uw/basestation3 GPS.py and LogFile.py
/// Errors   no glider, dive or start
[[nodiscard]] Checked<SeagliderLog> read_seaglider_log(std::string_view text);

struct SeagliderDepth {
  core::UtcTime time;
  core::Metres depth;
};

/// The columns elaps_t, seconds from the start of the dive, and depth, in centimetres as the basestation states of the
/// same column in its NetCDF. Rows whose depth is not a number are left out.
/// Errors   no glider, dive or start; no such columns
[[nodiscard]] Checked<std::vector<SeagliderDepth>> read_seaglider_record(std::string_view text);

}  // namespace floeplan::ingest

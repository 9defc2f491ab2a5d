#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/simulation/logs/log_table.hpp"
#include "storage/ingest/common/refusal.hpp"

namespace floeplan::ingest {

/// Sensors from which the track, the currents and the axes of the currents are computed, in the order of
/// SlocumRow.
inline constexpr auto slocum_sensors = std::to_array<std::string_view>(
    {"m_present_time", "m_lat", "m_lon", "m_gps_lat", "m_gps_lon", "m_gps_status", "m_depth", "x_dr_state",
     "m_water_vx", "m_water_vy", "m_initial_water_vx", "m_initial_water_vy", "m_final_water_vx",
     "m_final_water_vy", "m_gps_mag_var", "x_utm_to_lmc_00", "x_utm_to_lmc_01", "x_lmc_utm_zone_digit"});

enum class SlocumSensor {
  time,
  lat,
  lon,
  gps_lat,
  gps_lon,
  gps_status,
  depth,
  dr_state,
  water_x,
  water_y,
  initial_x,
  initial_y,
  final_x,
  final_y,
  variation,
  utm_to_lmc_00,
  utm_to_lmc_01,
  utm_zone
};

/// The values of one cycle of a log, in the log's own units; empty for a sensor that was not updated.
struct SlocumRow {
  std::array<std::optional<double>, slocum_sensors.size()> values{};

  [[nodiscard]] const std::optional<double>& operator[](SlocumSensor sensor) const {
    return values.at(static_cast<std::size_t>(sensor));
  }
};

/// Identifies a log, by the tags before its rows or else by its file name: "comet-2019-222-2-154" is segment
/// 154 of the third mission that comet began on day 223 of 2019 (the format counts days and missions from 0).
struct SlocumName {
  std::string glider;   // "comet"; empty: unknown
  std::string mission;  // "comet-2019-222-2.dbd": equal for all segments of one kind
  int segment{};
};

/// The statements of a log except its rows.
struct SlocumLog {
  SlocumName name;
  std::array<bool, slocum_sensors.size()> has{};  // whether the log lists the sensor
  std::int64_t rows_refused{};
  Messages warnings{};
};

/// The name of a log from the tags "key: value" at its beginning, or else from its file name up to the first
/// full stop.
[[nodiscard]] SlocumName slocum_name_of(const std::filesystem::path& file);

/// Whether a text is a log: comma-separated with sensor names, or as written by the vendor's dbd2asc.
[[nodiscard]] bool is_slocum_text(std::string_view head);

/// The sensors to read from a log: `slocum_sensors`, and those that show the notation of positions.
[[nodiscard]] std::vector<std::string_view> slocum_columns();

/// Passes the rows of a log to `take` in their order. Positions are in packed degrees and minutes; decimal
/// degrees are converted (see simulation::settle_positions).
/// Errors   the notation of positions is unknown
[[nodiscard]] Checked<SlocumLog> take_slocum_table(SlocumLog log, simulation::LogTable table,
                                                   const std::function<void(const SlocumRow&)>& take);

/// Reads a log in text form, as `take_slocum_table` does. A last line without a line end may have lost
/// digits; it is refused and counted.
/// Bounds   128 MB of text
/// Errors   lines that are not rows; no line of sensor names; those of `take_slocum_table`
[[nodiscard]] Checked<SlocumLog> read_slocum_text(const std::filesystem::path& file,
                                                  const std::function<void(const SlocumRow&)>& take);

}  // namespace floeplan::ingest

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

/// Sensors of a Slocum's log that its way, its currents and the axes of these follow from, in the order of SlocumRow.
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

/// What was logged in one cycle, in the log's own units; empty where a sensor was not updated.
struct SlocumRow {
  std::array<std::optional<double>, slocum_sensors.size()> values{};

  [[nodiscard]] const std::optional<double>& operator[](SlocumSensor sensor) const {
    return values.at(static_cast<std::size_t>(sensor));
  }
};

/// Which of a glider's logs a file is, by the tags before its rows, else by the file's name: "comet-2019-222-2-154" is segment 154 of the third
/// mission of comet that was begun on day 223 of 2019.
struct SlocumName {
  std::string glider;   // "comet"; empty: neither tells
  std::string mission;  // "comet-2019-222-2.dbd": the same of all segments of one kind
  int segment{};
};

/// What is told of a log beyond its rows.
struct SlocumLog {
  SlocumName name;
  std::array<bool, slocum_sensors.size()> has{};  // whether the log lists the sensor
  std::int64_t rows_refused{};
  Messages warnings{};
};

/// The name of a log by the tags "key: value" at its beginning, else by that of its file up to the first full stop.
[[nodiscard]] SlocumName slocum_name_of(const std::filesystem::path& file);

/// Whether a text is a log: comma-separated with the names of sensors, or as the vendor's dbd2asc writes it.
[[nodiscard]] bool is_slocum_text(std::string_view head);

/// The sensors that a log is read for: `slocum_sensors` and what tells how its positions are to be read.
[[nodiscard]] std::vector<std::string_view> slocum_columns();

/// Gives the rows of a log in their order to `take`, with positions in packed degrees and minutes, to which decimal ones
/// are brought (see simulation::settle_positions).
/// Errors   positions whose notation nothing tells
[[nodiscard]] Checked<SlocumLog> take_slocum_table(SlocumLog log, simulation::LogTable table,
                                                   const std::function<void(const SlocumRow&)>& take);

/// Reads a log as text, as `take_slocum_table`. A last line without its end may have lost digits; it is refused and
/// counted.
/// Bounds   128 MB of text
/// Errors   lines that are no row; no line of names; those of `take_slocum_table`
[[nodiscard]] Checked<SlocumLog> read_slocum_text(const std::filesystem::path& file,
                                                  const std::function<void(const SlocumRow&)>& take);

}  // namespace floeplan::ingest

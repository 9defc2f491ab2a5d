#include "storage/ingest/formats/slocum/slocum_netcdf.hpp"

#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "engine/messages/ingest_track_messages.hpp"
#include "storage/ingest/files/first_bytes.hpp"
#include "storage/ingest/formats/netcdf/measurement_line.hpp"

namespace floeplan::ingest {
namespace {

constexpr std::uint64_t most_rows = 2'000'000;  // with 25 sensors of 16 bytes 800 MB

std::optional<MeasurementLine> line_of(const NetcdfFile& file, std::string_view sensor) {
  return MeasurementLine::of(file, file.find(std::string{sensor}));
}

bool lie_along(const NetcdfFile& file, const MeasurementLine& time, std::string_view lat,
               std::string_view lon) {
  for (const std::string_view sensor : {lat, lon}) {
    const auto line = line_of(file, sensor);
    if (!line || line->dimension() != time.dimension()) return false;
  }
  return true;
}

}  // namespace

bool is_slocum_netcdf(const NetcdfFile& file) {
  const auto time = line_of(file, "m_present_time");
  return time &&
         (lie_along(file, *time, "m_gps_lat", "m_gps_lon") || lie_along(file, *time, "m_lat", "m_lon"));
}

bool holds_slocum_netcdf(const std::filesystem::path& file) {
  const std::string head = first_bytes(file, 8);
  if (!head.starts_with("CDF") && !head.starts_with("\x89HDF")) return false;
  const auto netcdf = NetcdfFile::open(file);
  return netcdf && is_slocum_netcdf(*netcdf);
}

Checked<SlocumLog> read_slocum_netcdf(const std::filesystem::path& path,
                                      const std::function<void(const SlocumRow&)>& take) {
  const auto file = NetcdfFile::open(path);
  if (!file) return refuse(file.error());
  const auto time = line_of(*file, "m_present_time");
  if (!time) return refuse(messages::ingest_track_message<"log-without-present-time">());
  if (time->size() > most_rows) return refuse(messages::ingest_track_message<"log-with-too-many-rows">());
  const auto rows = static_cast<std::size_t>(time->size());
  std::map<std::string, simulation::LogTable::Column> columns;
  std::map<std::string, std::string> units;
  for (const std::string_view sensor : slocum_columns()) {
    const auto line = line_of(*file, sensor);
    if (!line || line->dimension() != time->dimension()) continue;
    const auto values = line->read(0, rows);
    if (!values) return refuse(values.error());
    auto& column = columns[std::string{sensor}];
    column.assign(rows, std::nullopt);
    for (std::size_t row = 0; row < rows; ++row)
      if (std::isfinite((*values)[row])) column[row] = (*values)[row];
    units[std::string{sensor}] = line->variable().attribute("units");
  }
  return take_slocum_table(SlocumLog{}, simulation::LogTable::of(std::move(columns), std::move(units), rows),
                           take);
}

}  // namespace floeplan::ingest

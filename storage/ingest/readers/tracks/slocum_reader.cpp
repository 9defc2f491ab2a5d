#include <algorithm>

#include "engine/messages/ingest_track_messages.hpp"
#include "storage/ingest/formats/slocum/slocum_binary.hpp"
#include "storage/ingest/formats/slocum/slocum_header.hpp"
#include "storage/ingest/formats/slocum/slocum_log.hpp"
#include "storage/ingest/formats/slocum/slocum_netcdf.hpp"
#include "storage/ingest/readers/tracks/slocum_dives.hpp"
#include "storage/ingest/readers/tracks/track_builder.hpp"
#include "storage/ingest/readers/tracks/track_readers.hpp"

namespace floeplan::ingest {
namespace {

bool lists(const SlocumLog& log, SlocumSensor sensor) { return log.has.at(static_cast<std::size_t>(sensor)); }

/// Sensors that a log needs for a track but does not have; empty if none is missing.
std::string missing_in(const SlocumLog& log) {
  if (!lists(log, SlocumSensor::time)) return "m_present_time";
  const bool fixes = lists(log, SlocumSensor::gps_lat) && lists(log, SlocumSensor::gps_lon);
  const bool reckoned = lists(log, SlocumSensor::lat) && lists(log, SlocumSensor::lon);
  return fixes || reckoned ? "" : "m_gps_lat and m_gps_lon, nor m_lat and m_lon";
}

std::vector<std::string> names_in(const SlocumLog& log) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < slocum_sensors.size(); ++i)
    if (log.has.at(i)) names.emplace_back(slocum_sensors[i]);
  return names;
}

}  // namespace

Checked<PreparedDataset> read_slocum_tracks(const FileGroup& files, const core::ProgressCallback& progress) {
  std::string glider = files.front().stem().string();
  if (const auto name = slocum_name_of(files.front()); !name.glider.empty()) glider = name.glider;
  TrackBuilder track{glider};
  SlocumDives dives{track};
  std::vector<std::string> names;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (progress) progress("reading", static_cast<double>(i) / static_cast<double>(files.size()));
    if (holds_sensor_cache(files[i])) continue;
    dives.begin_log(slocum_name_of(files[i]).segment);
    const auto take = [&](const SlocumRow& row) { dives.take(row); };
    const auto log = holds_slocum_binary(files[i])   ? read_slocum_binary(files[i], files, take)
                     : holds_slocum_netcdf(files[i]) ? read_slocum_netcdf(files[i], take)
                                                     : read_slocum_text(files[i], take);
    if (!log) return refuse(log.error());
    if (const std::string missing = missing_in(*log); !missing.empty())
      return refuse(
          messages::ingest_track_message<"log-without-sensors">(files[i].filename().string(), missing));
    for (const messages::Message& warning : log->warnings) track.warn(warning);
    for (std::int64_t refused = log->rows_refused; refused > 0; --refused) track.refuse_row();
    if (names.empty()) names = names_in(*log);
  }
  dives.finish();
  return std::move(track).prepared(std::move(names));
}

}  // namespace floeplan::ingest

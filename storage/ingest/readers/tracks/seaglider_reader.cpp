#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "engine/messages/ingest_track_messages.hpp"
#include "storage/ingest/files/first_bytes.hpp"
#include "storage/ingest/formats/hdf5/hdf5_group.hpp"
#include "storage/ingest/formats/netcdf/measurement_line.hpp"
#include "storage/ingest/notation/cf_time.hpp"
#include "storage/ingest/notation/cf_units.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/tracks/seaglider_log.hpp"
#include "storage/ingest/readers/tracks/track_builder.hpp"
#include "storage/ingest/readers/tracks/track_readers.hpp"

namespace floeplan::ingest {
namespace {

constexpr std::uintmax_t most_log_bytes = 50'000'000;  // chosen: the longest dives write 1 MB

core::UtcTime middle_of(core::UtcTime a, core::UtcTime b) { return a + 0.5 * (b - a); }

void add_log(const SeagliderLog& log, TrackBuilder& track) {
  for (const auto& fix : {log.before, log.dived, log.surfaced})
    if (fix) track.add(TrackRow{.time = fix->time, .place = fix->place});
  for (std::int64_t left_out = log.fixes_left_out; left_out > 0; --left_out) track.refuse_row();
  if (!log.current || !log.dived || !log.surfaced) return;
  track.add(TrackCurrent{.time = middle_of(log.dived->time, log.surfaced->time),
                         .place = std::nullopt,
                         .current = *log.current});
  track.warn(messages::ingest_track_message<"seaglider-current-of-log">());
}

/// A column of measurements, with their times.
struct TimedColumn {
  MeasurementLine time;
  MeasurementLine values;
  CfTime calendar;
};

Checked<std::optional<TimedColumn>> timed(const NetcdfFile& file, const char* time_name, const char* name) {
  auto time = MeasurementLine::of(file, file.find(time_name));
  auto values = MeasurementLine::of(file, file.find(name));
  if (!time || !values || time->dimension() != values->dimension()) return std::optional<TimedColumn>{};
  auto calendar = CfTime::parse(time->variable().attribute("units"), time->variable().attribute("calendar"));
  if (!calendar) return refuse(calendar.error());
  return std::optional<TimedColumn>{{std::move(*time), std::move(*values), std::move(*calendar)}};
}

/// What a flag of the basestation says about its value.
enum class Worth : std::uint8_t { good, bad, unreadable };

/// The flags are texts of one character, which GDAL 3.6 does not read; HDF5 reads them.
Worth worth_of(const std::filesystem::path& path, const NetcdfFile& file, const char* flag) {
  if (file.find(flag) == nullptr) return Worth::good;
  const auto root = Hdf5Group::root_of(path);
  const std::string text = root ? root->characters(flag) : std::string{};
  if (text.size() != 1) return Worth::unreadable;
  return text == "3" || text == "4" || text == "9" ? Worth::bad : Worth::good;
}

Checked<std::vector<double>> all_values(const MeasurementLine& line) {
  return line.read(0, static_cast<std::size_t>(line.size()));
}

/// A numeric attribute of the file as text; older basestations wrote it as a text.
std::string stated_number(const NetcdfFile& file, const std::string& name) {
  const auto value = file.numeric_attribute(name);
  return value ? number(*value) : file.attribute(name);
}

std::string seaglider_name_of(const NetcdfFile& file) { return "sg" + stated_number(file, "glider"); }

/// The fixes of a dive. Their times are seconds since 1970, whatever the attributes say, because the
/// basestation writes them so.
Checked<std::vector<SeagliderFix>> fixes_of(const NetcdfFile& file) {
  std::vector<std::vector<double>> columns;
  for (const char* const name : {"log_gps_time", "log_gps_lat", "log_gps_lon"}) {
    const auto line = MeasurementLine::of(file, file.find(name));
    if (!line) return refuse(messages::ingest_track_message<"track-without-places">());
    auto values = all_values(*line);
    if (!values) return refuse(values.error());
    columns.push_back(std::move(*values));
  }
  std::vector<SeagliderFix> fixes;
  const std::size_t count = std::min({columns[0].size(), columns[1].size(), columns[2].size()});
  for (std::size_t i = 0; i < count; ++i) {
    const bool is_time = columns[0][i] > 0.0 && columns[0][i] < 7.3e9;  // the year 2201
    if (is_time && std::isfinite(columns[1][i]) && std::isfinite(columns[2][i]))
      fixes.push_back({core::from_unix_seconds(columns[0][i]), {columns[2][i], columns[1][i]}});
  }
  return fixes;
}

Checked<bool> add_dive(const std::filesystem::path& path, const NetcdfFile& file, TrackBuilder& track) {
  auto depths = timed(file, "ctd_time", "ctd_depth");
  if (depths && !*depths) depths = timed(file, "time", "depth");
  if (!depths) return refuse(depths.error());
  if (!*depths) return true;
  const TimedColumn& column = **depths;
  const auto factor = length_factor(column.values.variable().attribute("units"));
  if (!factor) {
    track.warn(messages::ingest_track_message<"track-depth-without-unit">(column.values.variable().name()));
    return true;
  }
  const auto times = all_values(column.time);
  const auto values = all_values(column.values);
  for (const auto* const read : {&times, &values})
    if (!*read) return refuse(read->error());

  std::vector<double> lons(times->size(), std::nan(""));
  std::vector<double> lats = lons;
  if (worth_of(path, file, "latlong_qc") != Worth::good) {
    track.warn(messages::ingest_track_message<"seaglider-reckoned-places-bad">());
  } else {
    for (const auto& [name, places] : {std::pair{"longitude", &lons}, std::pair{"latitude", &lats}}) {
      const auto line = MeasurementLine::of(file, file.find(name));
      if (!line || line->dimension() != column.time.dimension()) continue;
      auto read = all_values(*line);
      if (!read) return refuse(read.error());
      *places = std::move(*read);
    }
  }
  for (std::size_t i = 0; i < times->size(); ++i) {
    const auto time = column.calendar.at((*times)[i]);
    if (!time) {
      track.refuse_row();
      continue;
    }
    TrackRow row{.time = *time, .fixed = false};
    if (std::isfinite((*values)[i])) row.depth = core::Metres{*factor * (*values)[i]};
    if (std::isfinite(lons[i]) && std::isfinite(lats[i])) row.place = geo::LonLat{lons[i], lats[i]};
    track.add(row);
  }
  return true;
}

Checked<bool> add_current(const std::filesystem::path& path, const NetcdfFile& file,
                          const std::vector<SeagliderFix>& fixes, TrackBuilder& track) {
  const NetcdfVariable* const east = file.find("depth_avg_curr_east");
  const NetcdfVariable* const north = file.find("depth_avg_curr_north");
  if (east == nullptr || north == nullptr || fixes.size() < 2) return true;
  const Worth worth = worth_of(path, file, "depth_avg_curr_qc");
  if (worth != Worth::good) {
    track.warn(worth == Worth::bad ? messages::ingest_track_message<"seaglider-current-bad">()
                                   : messages::ingest_track_message<"seaglider-flags-unreadable">());
    return true;
  }
  const auto east_factor = speed_factor(east->attribute("units"));
  const auto north_factor = speed_factor(north->attribute("units"));
  if (!east_factor || !north_factor) {
    track.warn(messages::ingest_track_message<"currents-without-unit">((east_factor ? north : east)->name()));
    return true;
  }
  const auto u = east->read_all();
  const auto v = north->read_all();
  for (const auto* const read : {&u, &v})
    if (!*read) return refuse(read->error());
  if (u->size() != 1 || v->size() != 1 || !std::isfinite(u->front()) || !std::isfinite(v->front()))
    return true;
  // The last two fixes are the one before and the one after the dive.
  track.add(TrackCurrent{.time = middle_of(fixes[fixes.size() - 2].time, fixes.back().time),
                         .place = std::nullopt,
                         .current = {{*east_factor * u->front()}, {*north_factor * v->front()}}});
  return true;
}

void tell(const core::ProgressCallback& progress, std::size_t done, std::size_t all) {
  if (progress) progress("reading", static_cast<double>(done) / static_cast<double>(all));
}

}  // namespace

Checked<PreparedDataset> read_seaglider_logs(const FileGroup& files, const core::ProgressCallback& progress) {
  std::optional<TrackBuilder> track;
  bool depths_alone = true;
  std::set<std::string> names;
  for (std::size_t i = 0; i < files.size(); ++i) {
    tell(progress, i, files.size());
    if (std::filesystem::file_size(files[i]) > most_log_bytes)
      return refuse(messages::ingest_track_message<"seaglider-log-too-long">());
    const std::string text = first_bytes(files[i], most_log_bytes);
    const auto dive = seaglider_dive_of(text);
    if (!dive) return refuse(dive.error());
    if (!track) track.emplace(dive->glider);
    if (is_seaglider_record(text)) {
      const auto depths = read_seaglider_record(text);
      if (!depths) return refuse(depths.error());
      for (const SeagliderDepth& row : *depths)
        track->add(TrackRow{.time = row.time, .depth = row.depth, .fixed = false});
      names.insert({"elaps_t", "depth"});
      continue;
    }
    depths_alone = false;
    const auto log = read_seaglider_log(text);
    if (!log) return refuse(log.error());
    add_log(*log, *track);
    names.insert({"GPS1", "GPS2", "GPS"});
    if (log->current) names.insert("CURRENT");
  }
  if (depths_alone) return refuse(messages::ingest_track_message<"seaglider-record-alone">());
  return std::move(*track).prepared({names.begin(), names.end()});
}

bool is_seaglider_dive(const NetcdfFile& file) {
  return file.find("log_gps_time") != nullptr && file.find("log_gps_lat") != nullptr &&
         file.find("log_gps_lon") != nullptr;
}

std::string seaglider_mission_of(const NetcdfFile& file) {
  return seaglider_name_of(file) + " mission " + stated_number(file, "mission") + " netcdf";
}

Checked<PreparedDataset> read_seaglider_netcdf(const FileGroup& files,
                                               const core::ProgressCallback& progress) {
  std::optional<TrackBuilder> track;
  for (std::size_t i = 0; i < files.size(); ++i) {
    tell(progress, i, files.size());
    const auto file = NetcdfFile::open(files[i]);
    if (!file) return refuse(file.error());
    if (!track) track.emplace(seaglider_name_of(*file));
    const auto fixes = fixes_of(*file);
    if (!fixes) return refuse(fixes.error());
    for (const SeagliderFix& fix : *fixes) track->add(TrackRow{.time = fix.time, .place = fix.place});
    if (const auto added = add_dive(files[i], *file, *track); !added) return refuse(added.error());
    if (const auto added = add_current(files[i], *file, *fixes, *track); !added) return refuse(added.error());
  }
  return std::move(*track).prepared({"log_gps_time", "log_gps_lat", "log_gps_lon", "ctd_depth",
                                     "depth_avg_curr_east", "depth_avg_curr_north"});
}

}  // namespace floeplan::ingest

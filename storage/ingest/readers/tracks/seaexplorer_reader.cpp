#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "engine/core/utc_text.hpp"
#include "engine/messages/ingest_track_messages.hpp"
#include "engine/mission/document/packed_degrees.hpp"
#include "storage/ingest/files/first_bytes.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/tracks/track_builder.hpp"
#include "storage/ingest/readers/tracks/track_readers.hpp"

namespace floeplan::ingest {
namespace {

constexpr std::uintmax_t most_bytes_of_text = 128'000'000;
constexpr double at_surface = 116.0;  // the state in which it takes fixes and transmits

std::vector<std::string> semicolon_fields(std::string_view line) {
  std::vector<std::string> fields;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(';', begin), line.size());
    fields.push_back(trimmed(line.substr(begin, end - begin)));
    begin = end + 1;
  }
  return fields;
}

/// A time such as "17/05/2019 22:28:41.230", in UTC.
std::optional<core::UtcTime> seaexplorer_time(const std::string& text) {
  constexpr std::size_t date_length = 10;
  if (text.size() < 19 || text[2] != '/' || text[5] != '/' || text[date_length] != ' ') return std::nullopt;
  return core::parse_iso8601(text.substr(6, 4) + "-" + text.substr(3, 2) + "-" + text.substr(0, 2) + "T" +
                             text.substr(date_length + 1) + "Z");
}

/// Positions of the columns that a track needs; empty if there is no such column.
struct SeaexplorerColumns {
  std::optional<std::size_t> time, lat, lon, depth, state;
};

SeaexplorerColumns columns_in(const std::vector<std::string>& names) {
  const auto find = [&](const char* of_navigation, const char* of_payload) {
    const auto found = std::ranges::find_if(
        names, [&](const std::string& name) { return name == of_navigation || name == of_payload; });
    return found == names.end() ? std::nullopt
                                : std::optional{static_cast<std::size_t>(found - names.begin())};
  };
  return {.time = find("Timestamp", "PLD_REALTIMECLOCK"),
          .lat = find("Lat", "NAV_LATITUDE"),
          .lon = find("Lon", "NAV_LONGITUDE"),
          .depth = find("Depth", "NAV_DEPTH"),
          .state = find("NavState", "NAV_RESOURCE")};
}

/// Adds the rows of one file to a track.
class SeaexplorerRows {
 public:
  SeaexplorerRows(SeaexplorerColumns columns, TrackBuilder& track) : columns_{columns}, track_{track} {}

  void take(const std::vector<std::string>& fields) {
    const auto number = [&](const std::optional<std::size_t>& column) -> std::optional<double> {
      return column && *column < fields.size() ? parse_number(fields[*column]) : std::nullopt;
    };
    const auto time =
        *columns_.time < fields.size() ? seaexplorer_time(fields[*columns_.time]) : std::nullopt;
    const auto lat = number(columns_.lat);
    const auto lon = number(columns_.lon);
    // Zeros mean that there was no fix since the vehicle was switched on. Its clock may then be wrong by
    // years.
    if (!time || !lat || !lon || (*lat == 0.0 && *lon == 0.0)) return track_.refuse_row();
    const bool surfaced = number(columns_.state) == at_surface;
    TrackRow row{.time = *time, .fixed = surfaced};
    if (const auto depth_m = number(columns_.depth)) row.depth = core::Metres{*depth_m};
    const bool moved = has_last_ && (*lon != last_lon_ || *lat != last_lat_);
    if (surfaced || moved) row.place = mission::unpack_place(*lon, *lat);
    has_last_ = true;
    last_lon_ = *lon;
    last_lat_ = *lat;
    track_.add(row);
  }

 private:
  SeaexplorerColumns columns_;
  TrackBuilder& track_;  // borrowed
  bool has_last_{false};
  double last_lon_{};  // packed, from the row before
  double last_lat_{};
};

Checked<bool> add_file(const std::filesystem::path& file, TrackBuilder& track,
                       std::vector<std::string>& names) {
  if (std::filesystem::file_size(file) > most_bytes_of_text)
    return refuse(messages::ingest_track_message<"log-too-long">());
  std::string text = first_bytes(file, most_bytes_of_text);
  if (!text.ends_with('\n')) {
    text.resize(text.rfind('\n') == std::string::npos ? 0 : text.rfind('\n') + 1);
    track.refuse_row();
    track.warn(messages::ingest_track_message<"log-row-left-out">());
  }
  std::optional<SeaexplorerRows> rows;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    const auto fields = semicolon_fields(std::string_view{text}.substr(begin, end - begin));
    begin = end + 1;
    if (rows) {
      rows->take(fields);
      continue;
    }
    const SeaexplorerColumns columns = columns_in(fields);
    if (!columns.time || !columns.lat || !columns.lon) break;
    if (names.empty())
      for (const auto& column : {columns.time, columns.lat, columns.lon, columns.depth})
        if (column) names.push_back(fields[*column]);
    rows.emplace(columns, track);
  }
  if (!rows)
    return refuse(messages::ingest_track_message<"log-without-sensors">(
        file.filename().string(),
        "Timestamp, Lat and Lon, nor PLD_REALTIMECLOCK, NAV_LATITUDE and NAV_LONGITUDE"));
  return true;
}

}  // namespace

bool is_seaexplorer_text(std::string_view head) {
  const std::string_view first = head.substr(0, head.find('\n'));
  return (first.starts_with("Timestamp;NavState;") && contains_any(first, {";Lat;"})) ||
         first.starts_with("PLD_REALTIMECLOCK;");
}

SeaexplorerName seaexplorer_name_of(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= name.size();) {
    const std::size_t end = std::min(name.find('.', begin), name.size());
    parts.push_back(name.substr(begin, end - begin));
    begin = end + 1;
  }
  SeaexplorerName result{.glider = parts.front()};
  const auto dive = parts.size() == 5 ? parse_number(parts[4]) : std::nullopt;
  if (!dive) return result;
  result.mission = parts[0] + "." + parts[1] + "." + parts[2];
  result.dive = static_cast<int>(*dive);
  return result;
}

Checked<PreparedDataset> read_seaexplorer_texts(const FileGroup& files,
                                                const core::ProgressCallback& progress) {
  TrackBuilder track{seaexplorer_name_of(files.front()).glider};
  std::vector<std::string> names;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (progress) progress("reading", static_cast<double>(i) / static_cast<double>(files.size()));
    if (const auto added = add_file(files[i], track, names); !added) return refuse(added.error());
  }
  return std::move(track).prepared(std::move(names));
}

}  // namespace floeplan::ingest

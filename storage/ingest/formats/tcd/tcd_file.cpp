#include "storage/ingest/formats/tcd/tcd_file.hpp"

#include <tcd.h>

#include <cstdint>
#include <fstream>
#include <memory>

#include "engine/messages/ingest_file_messages.hpp"
#include "engine/messages/ingest_tide_messages.hpp"
#include "storage/ingest/notation/table_text.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

constexpr std::size_t header_bytes = 4096;
constexpr std::uint32_t most_stations = 100'000;
constexpr std::string_view length_key = "[END OF FILE] = ";

/// Hours of a number hhmm: "-330" is -3.5 h, west of Greenwich.
double hours_of(std::int32_t hours_and_minutes) {
  return hours_and_minutes / 100 + (hours_and_minutes % 100) / 60.0;
}

TcdStation station_of(const TIDE_RECORD& record, std::size_t constituents) {
  TcdStation station{.name = table_text(record.header.name),
                     .lon_deg = record.header.longitude,
                     .lat_deg = record.header.latitude,
                     .unit = table_text(get_level_units(record.level_units)),
                     .zone_h = hours_of(record.zone_offset),
                     .has_constants = record.header.record_type == REFERENCE_STATION,
                     .constants = {}};
  for (std::size_t i = 0; station.has_constants && i < constituents; ++i)
    if (record.amplitude[i] > 0.0F)
      station.constants.push_back(
          {i, static_cast<double>(record.amplitude[i]), static_cast<double>(record.epoch[i])});
  return station;
}

}  // namespace

bool is_tcd(std::string_view head) {
  return head.starts_with("[VERSION]") && head.find("[NUMBER OF RECORDS]") != std::string_view::npos &&
         head.find("[CONSTITUENTS]") != std::string_view::npos;
}

Checked<bool> is_whole_tcd(const std::filesystem::path& file) {
  std::string head(header_bytes, '\0');
  std::ifstream{file, std::ios::binary}.read(head.data(), static_cast<std::streamsize>(head.size()));
  const std::size_t at = head.find(length_key);
  if (at == std::string::npos) return refuse(messages::ingest_tide_message<"tcd-damaged">());
  const std::size_t begin = at + length_key.size();
  const auto stated =
      parse_number(trimmed(std::string_view{head}.substr(begin, head.find('\n', begin) - begin)));
  if (!stated || !(*stated >= 0.0 && *stated < 1e12))
    return refuse(messages::ingest_tide_message<"tcd-damaged">());
  const std::uint64_t size = std::filesystem::file_size(file);
  if (static_cast<double>(size) < *stated)
    return refuse(messages::ingest_file_message<"file-cut-short">(
        "database of tides", static_cast<std::uint64_t>(*stated), "bytes", size));
  return true;
}

Checked<TcdFile> read_tcd(const std::filesystem::path& file) {
  std::string path = file.string();
  if (open_tide_db(path.data()) == NVFalse) return refuse(messages::ingest_tide_message<"tcd-damaged">());
  const std::unique_ptr<void, void (*)(void*)> open{&path, [](void*) { close_tide_db(); }};
  const DB_HEADER_PUBLIC header = get_tide_db_header();
  if (header.number_of_records > most_stations)
    return refuse(messages::ingest_tide_message<"too-many-places">());
  if (header.constituents > MAX_CONSTITUENTS) return refuse(messages::ingest_tide_message<"tcd-damaged">());

  TcdFile result;
  for (std::uint32_t i = 0; i < header.constituents; ++i) {
    const auto index = static_cast<std::int32_t>(i);
    result.constituents.push_back({table_text(get_constituent(index)), get_speed(index)});
  }
  const auto record = std::make_unique<TIDE_RECORD>();
  for (std::uint32_t i = 0; i < header.number_of_records; ++i) {
    if (read_tide_record(static_cast<std::int32_t>(i), record.get()) < 0)
      return refuse(messages::ingest_tide_message<"tcd-damaged">());
    result.stations.push_back(station_of(*record, header.constituents));
  }
  return result;
}

}  // namespace floeplan::ingest

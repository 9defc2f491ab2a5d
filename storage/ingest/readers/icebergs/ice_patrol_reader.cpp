#include <algorithm>
#include <array>
#include <fstream>
#include <optional>

#include "engine/core/utc_text.hpp"
#include "engine/messages/ingest_iceberg_messages.hpp"
#include "storage/ingest/notation/delimited_text.hpp"
#include "storage/ingest/notation/stated_place.hpp"
#include "storage/ingest/notation/table_dates.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/icebergs/iceberg_readers.hpp"
#include "storage/ingest/readers/icebergs/iceberg_rows.hpp"
#include "storage/ingest/readers/icebergs/position_errors.hpp"

namespace floeplan::ingest {
namespace {

// Endings of the columns' names; the yearly files differ: "ICE-YEAR" and "ICEBERG_YEAR", "DATE" and
// "SIGHTING_DATE".
constexpr std::array<std::string_view, 9> column_names{"YEAR",      "NUMBER", "DATE", "TIME", "LATITUDE",
                                                       "LONGITUDE", "METHOD", "SIZE", "SHAPE"};
enum Column { ice_year, berg_number, date, time_of_day, latitude, longitude, method, size, shape };

/// Position of each column in the file.
using ColumnNumbers = std::array<std::size_t, column_names.size()>;

std::string_view plain_name(std::string_view column) {
  for (const std::string_view word : {"ICEBERG_", "ICE-", "ICE_", "BERG_", "SIGHTING_"})
    if (column.starts_with(word)) return column.substr(word.size());
  return column;
}

std::optional<ColumnNumbers> find_columns(const std::vector<std::string>& header) {
  ColumnNumbers columns{};
  for (std::size_t i = 0; i < column_names.size(); ++i) {
    const auto found = std::ranges::find(header, column_names[i], &plain_name);
    if (found == header.end()) return std::nullopt;
    columns[i] = static_cast<std::size_t>(found - header.begin());
  }
  return columns;
}

std::string without_mark(std::string line) {
  if (line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);
  while (line.ends_with('\r')) line.pop_back();
  return line;
}

std::optional<ocean::IcebergSize> size_of_code(const std::string& code) {
  using ocean::IcebergSize;
  if (code == "GR") return IcebergSize::growler;
  if (code == "BB") return IcebergSize::bergy_bit;
  if (code == "SM") return IcebergSize::small;
  if (code == "MED") return IcebergSize::medium;
  if (code == "LG") return IcebergSize::large;
  if (code == "VLG") return IcebergSize::very_large;
  if (code == "GEN" || code == "UNK") return IcebergSize::unknown;
  if (code == "RAD") return IcebergSize::radar_target;
  return std::nullopt;
}

/// UTC time from "10/7/2013" or "2013-10-07", and "2139" (leading zeros may have been lost).
std::optional<core::UtcTime> sighting_time(const std::string& date_text, const std::string& time_text) {
  const bool american = date_text.find('/') != std::string::npos;
  const auto date = american ? us_date(date_text) : core::parse_iso8601(date_text);
  const auto clock = whole_number(time_text);
  const bool four_digits = american ? date_text.size() > 5 && date_text[date_text.size() - 5] == '/'
                                    : date_text.size() == std::string_view{"2021-03-04"}.size();
  if (!date || !four_digits || !clock) return std::nullopt;
  if (time_text.size() > 4 || *clock < 0 || *clock / 100 > 23 || *clock % 100 > 59) return std::nullopt;
  const int hour = *clock / 100;
  const int minute = *clock % 100;
  return *date + core::Seconds{hour * 3600.0 + minute * 60.0};
}

/// The sighting of one row, or why the row is bad.
Checked<ocean::Iceberg> sighting(const std::vector<std::string>& fields, const ColumnNumbers& columns) {
  const auto field = [&](Column column) { return trimmed(fields[columns[column]]); };
  ocean::Iceberg iceberg;
  if (!whole_number(field(ice_year)) || field(berg_number).empty())
    return refuse(messages::ingest_iceberg_message<"iceberg-year-or-number-missing">());
  iceberg.id = field(ice_year) + "-" + field(berg_number);

  const auto observed = sighting_time(field(date), field(time_of_day));
  if (!observed)
    return refuse(
        messages::ingest_iceberg_message<"iceberg-date-unusable">(field(date) + " " + field(time_of_day)));
  iceberg.observed = *observed;

  const auto lat = parse_number(field(latitude));
  const auto lon = parse_number(field(longitude));
  if (!lat || !lon)
    return refuse(
        messages::ingest_iceberg_message<"iceberg-position-unusable">(field(latitude), field(longitude)));
  iceberg.place = {*lon, *lat};
  if (auto fault = fault_of_place(iceberg.place)) return refuse(std::move(*fault));

  const auto known_size = size_of_code(field(size));
  if (!known_size)
    return refuse(messages::ingest_iceberg_message<"iceberg-size-unknown-to-ice-patrol">(field(size)));
  iceberg.size = *known_size;
  iceberg.shape = field(shape);
  iceberg.method = field(method);
  return iceberg;
}

}  // namespace

bool is_ice_patrol_header(const std::string& line) {
  return find_columns(csv_fields(without_mark(line))).has_value();
}

Checked<PreparedDataset> read_ice_patrol_csv(const std::filesystem::path& file) {
  std::ifstream in{file};
  std::string line;
  std::getline(in, line);
  const std::vector<std::string> header = csv_fields(without_mark(line));
  const auto columns = find_columns(header);
  if (!columns) return refuse(messages::ingest_iceberg_message<"iceberg-columns-not-of-ice-patrol">());

  const PositionErrors position_errors{header};
  IcebergRows rows;
  for (int line_number = 2; std::getline(in, line); ++line_number) {
    const std::string where = "line " + std::to_string(line_number);
    const std::vector<std::string> fields = csv_fields(without_mark(line));
    if (fields.size() == 1 && trimmed(fields.front()).empty()) continue;
    if (fields.size() != header.size()) {
      rows.reject(where,
                  messages::ingest_iceberg_message<"iceberg-row-short">(
                      fields.size(), header.size(), in.eof() ? "; the file seems to be cut short" : ""));
      continue;
    }
    auto iceberg = sighting(fields, *columns);
    if (iceberg) iceberg = with_position_error(std::move(*iceberg), position_errors, fields);
    if (iceberg) {
      rows.accept(std::move(*iceberg));
    } else {
      rows.reject(where, iceberg.error().front());
    }
  }
  return std::move(rows).prepared(header, position_errors.warnings());
}

}  // namespace floeplan::ingest
